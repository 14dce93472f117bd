#include "delaunay/hole_refill.h"

#include <algorithm>

namespace mesher {

bool keepsConstrainedEdges(const Triangulation3d& mesh, std::span<const TetId> before,
                           std::span<const TetCorners> after)
{
    const auto has = [](const TetCorners& tet, VertexId v) {
        return std::find(tet.begin(), tet.end(), v) != tet.end();
    };
    for (const TetId tet : before) {
        for (int edge = 0; edge < 6; ++edge) {
            if (!mesh.isEdgeConstrained(tet, edge)) continue;
            const VertexId a = mesh.vertex(tet, kEdgeSlots[edge][0]);
            const VertexId b = mesh.vertex(tet, kEdgeSlots[edge][1]);
            const bool isKept = std::any_of(after.begin(), after.end(), [&](const TetCorners& other) {
                return has(other, a) && has(other, b);
            });
            if (!isKept) return false;
        }
    }
    return true;
}

bool HoleRefill::refill(std::span<const TetId> tets, VertexId without, std::size_t most)
{
    tets_.assign(tets.begin(), tets.end());
    while (true) {
        if (!makeShell(without)) return false;
        filling_.clear();
        if (cavities_.fillDelaunay(shell_, inside_, filling_)) break;
        if (cavities_.missing().empty() || !enlarge(most)) return false;
    }
    if (!keepsConstrainedEdges(mesh_, tets_, filling_)) return false;
    replacement_.replace(tets_, filling_);
    return true;
}

bool HoleRefill::enlarge(std::size_t most)
{
    for (const auto& key : cavities_.missing()) {
        const TetFace outer = shell_.faces().at(key).outer;
        if (mesh_.isFaceConstrained(outer) || mesh_.isGhostTet(outer.tet())) return false;
        if (std::find(tets_.begin(), tets_.end(), outer.tet()) == tets_.end()) tets_.push_back(outer.tet());
    }
    return tets_.size() <= most;
}

/// False if a constrained face lies within.
bool HoleRefill::makeShell(VertexId without)
{
    shell_.clear();
    inside_.clear();
    std::vector<VertexId> onShell;
    for (const TetId tet : tets_) {
        for (int face = 0; face < 4; ++face) {
            const TetFace outer = mesh_.neighbour(tet, face);
            if (std::find(tets_.begin(), tets_.end(), outer.tet()) != tets_.end()) {
                if (mesh_.isFaceConstrained(outer)) return false;
                continue;
            }
            const auto corner = mesh_.faceVertices({tet, face});
            if (!shell_.add({corner, outer})) return false;
            onShell.insert(onShell.end(), corner.begin(), corner.end());
        }
    }
    for (const TetId tet : tets_) {
        for (const VertexId v : mesh_.tet(tet).vertex) {
            if (v != without && std::find(onShell.begin(), onShell.end(), v) == onShell.end() &&
                std::find(inside_.begin(), inside_.end(), v) == inside_.end()) {
                inside_.push_back(v);
            }
        }
    }
    return true;
}

}  // namespace mesher
