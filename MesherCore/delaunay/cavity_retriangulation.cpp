#include "delaunay/cavity_retriangulation.h"

#include "delaunay/deepest_point.h"
#include "predicates/orient3d.h"

#include <algorithm>

namespace mesher {

namespace {

CavityShell::Corners sorted(CavityShell::Corners corner)
{
    std::sort(corner.begin(), corner.end());
    return corner;
}

bool isEvenPermutation(const CavityShell::Corners& a, const CavityShell::Corners& b)
{
    for (unsigned turn = 0; turn < 3; ++turn) {
        if (a[0] == b[turn] && a[1] == b[(turn + 1) % 3] && a[2] == b[(turn + 2) % 3]) return true;
    }
    return false;
}

}  // namespace

bool CavityShell::add(const Face& face)
{
    const auto [place, isNew] = faces_.emplace(sorted(face.corner), face);
    if (isNew) return true;
    if (isEvenPermutation(place->second.corner, face.corner)) return false;
    faces_.erase(place);
    return true;
}

void CavityShell::remove(const Corners& corner) { faces_.erase(sorted(corner)); }

bool CavityRetriangulation::fillDelaunay(const CavityShell& shell, std::span<const VertexId> insideVertices,
                                         std::vector<TetCorners>& filling)
{
    missing_.clear();
    corners_.assign(insideVertices.begin(), insideVertices.end());
    for (const auto& [key, face] : shell.faces()) corners_.insert(corners_.end(), key.begin(), key.end());
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    local_.triangulate(mesh_, corners_);
    if (!local_.isInSpace()) return false;
    const std::size_t start = filling.size();
    if (!flood(shell, filling)) return false;
    for (const VertexId inside : insideVertices) {
        const bool isUsed = std::any_of(
            filling.begin() + static_cast<std::ptrdiff_t>(start), filling.end(),
            [&](const TetCorners& tet) { return std::find(tet.begin(), tet.end(), inside) != tet.end(); });
        if (!isUsed) return false;
    }
    return true;
}

bool CavityRetriangulation::flood(const CavityShell& shell, std::vector<TetCorners>& filling)
{
    const Triangulation3d& tets = local_.tets();
    std::map<CavityShell::Corners, bool> isFound;
    for (const auto& [key, face] : shell.faces()) isFound.emplace(key, false);
    for (std::uint32_t i = 0; i < tets.tetLimit(); ++i) {
        if (!tets.isAlive(TetId(i))) continue;
        for (int face = 0; face < 4; ++face) {
            const auto [a, b, c] = tets.faceVertices({TetId(i), face});
            if (isGhost(a) || isGhost(b) || isGhost(c)) continue;
            const CavityShell::Corners corner{local_.original(a), local_.original(b), local_.original(c)};
            const auto found = shell.faces().find(sorted(corner));
            if (found == shell.faces().end()) continue;
            const bool isInside = isEvenPermutation(found->second.corner, corner);
            local_.bound({TetId(i), face}, isInside);
            if (isInside) isFound[found->first] = true;
        }
    }
    for (const auto& [key, found] : isFound) {
        if (!found) missing_.push_back(key);
    }
    return missing_.empty() && local_.flood(false, filling);
}

bool CavityRetriangulation::findKernelPoint(const CavityShell& shell, Vec3& point) const
{
    std::vector<std::array<Vec3, 3>> faces;
    for (const auto& [key, face] : shell.faces()) {
        const auto& v = face.corner;
        faces.push_back({mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])});
    }
    if (faces.empty()) return false;
    point = deepestPoint(faces);
    return std::all_of(faces.begin(), faces.end(), [&](const auto& face) {
        return orient3d(face[0], face[1], face[2], point) == Sign::Positive;
    });
}

}  // namespace mesher
