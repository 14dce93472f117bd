#include "delaunay/vertex_removal3d.h"

#include <algorithm>

namespace mesher {

namespace {

/// The same oriented face whatever corner it starts with.
std::array<VertexId, 3> smallestFirst(const std::array<VertexId, 3>& face)
{
    if (face[0] < face[1] && face[0] < face[2]) return face;
    if (face[1] < face[2]) return {face[1], face[2], face[0]};
    return {face[2], face[0], face[1]};
}

/// The ghost is the largest id, so it is never first; which of the others it is depends on the sense of the face.
bool hasGhost(const std::array<VertexId, 3>& face) { return isGhost(face[1]) || isGhost(face[2]); }

}  // namespace

VertexRemoval3d::VertexRemoval3d(Triangulation3d& mesh) : mesh_(mesh), replacement_(mesh) {}

VertexHole3d VertexRemoval3d::find(VertexId vertex)
{
    vertex_ = vertex;
    mesh_.collectStar(vertex, star_);
    if (isOnConstraint()) return VertexHole3d::OnConstraint;
    collectHole();
    filling_.clear();
    local_.triangulate(mesh_, corners_);
    if (!local_.isInSpace()) {
        const bool hasOthers = std::any_of(holeFaces_.begin(), holeFaces_.end(), [&](const HoleFace& face) {
            return !hasGhost(face.corner) && !mesh_.isGhostTet(face.outer.tet());
        });
        if (!hasOthers) return hasConstraint() ? VertexHole3d::Untriangulable : VertexHole3d::WholeSpace;
        fillFlatHole();
        return VertexHole3d::Ready;
    }
    return fillFromDelaunay() ? VertexHole3d::Ready : VertexHole3d::Untriangulable;
}

bool VertexRemoval3d::isOnConstraint() const
{
    for (const TetId tet : star_) {
        const std::uint16_t flags = mesh_.flags(tet);
        if ((flags & tet_flag::kConstraints) == 0) continue;
        const int slot = mesh_.slotOf(tet, vertex_);
        for (int other = 0; other < 4; ++other) {
            if (other == slot) continue;
            if ((flags & tet_flag::face(other)) != 0) return true;
            if ((flags & tet_flag::edge(kEdgeOfSlots[slot][other])) != 0) return true;
        }
    }
    return false;
}

bool VertexRemoval3d::hasConstraint() const
{
    return std::any_of(star_.begin(), star_.end(),
                       [&](TetId tet) { return (mesh_.flags(tet) & tet_flag::kConstraints) != 0; });
}

void VertexRemoval3d::collectHole()
{
    holeFaces_.clear();
    corners_.clear();
    for (const TetId tet : star_) {
        const int slot = mesh_.slotOf(tet, vertex_);
        const auto face = mesh_.faceVertices({tet, slot});
        holeFaces_.push_back({smallestFirst(face), mesh_.neighbour(tet, slot)});
        for (const VertexId corner : face) {
            if (!isGhost(corner)) corners_.push_back(corner);
        }
    }
    std::sort(holeFaces_.begin(), holeFaces_.end(),
              [](const HoleFace& a, const HoleFace& b) { return a.corner < b.corner; });
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
}

/// The hole of a vertex whose neighbours are coplanar has no volume: the faces below become hull facets.
void VertexRemoval3d::fillFlatHole()
{
    for (const HoleFace& face : holeFaces_) {
        if (hasGhost(face.corner)) continue;
        filling_.push_back({face.corner[0], face.corner[1], face.corner[2], kGhostVertex});
    }
}

bool VertexRemoval3d::isHoleFace(const std::array<VertexId, 3>& corner) const
{
    const auto found = std::lower_bound(
        holeFaces_.begin(), holeFaces_.end(), corner,
        [](const HoleFace& face, const std::array<VertexId, 3>& key) { return face.corner < key; });
    return found != holeFaces_.end() && found->corner == corner;
}

bool VertexRemoval3d::fillFromDelaunay()
{
    const Triangulation3d& tets = local_.tets();
    std::size_t matched = 0;
    for (std::uint32_t i = 0; i < tets.tetLimit(); ++i) {
        if (!tets.isAlive(TetId(i))) continue;
        for (int face = 0; face < 4; ++face) {
            const auto [a, b, c] = tets.faceVertices({TetId(i), face});
            const auto corner = smallestFirst({local_.original(a), local_.original(b), local_.original(c)});
            if (!isHoleFace(corner)) continue;
            ++matched;
            local_.bound({TetId(i), face}, true);
        }
    }
    return matched == holeFaces_.size() && local_.flood(true, filling_);
}

TetId VertexRemoval3d::commit()
{
    const TetId created = replacement_.replace(star_, filling_);
    mesh_.removeVertex(vertex_);
    return created;
}

}  // namespace mesher
