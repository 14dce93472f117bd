#include "delaunay/facet_flip3d.h"

#include "delaunay/flips3d.h"

#include <algorithm>

namespace mesher {

bool flipFacetPair(Triangulation3d& mesh, const std::array<VertexId, 2>& edge,
                   const std::array<VertexId, 2>& apices, std::vector<TetId>& changed)
{
    const TetId at = mesh.findEdge(edge[0], edge[1]);
    if (!at.isValid()) return false;
    const int slot = kEdgeOfSlots[mesh.slotOf(at, edge[0])][mesh.slotOf(at, edge[1])];
    for (const int diagonal : {0, 1}) {
        const std::optional<Flip3d> flip = evaluateFlip44(mesh, at, slot, diagonal);
        if (!flip || flip->constrainedFaces.empty()) continue;
        const auto& face = flip->constrainedFaces.front();
        const auto has = [&](VertexId v) { return std::find(face.begin(), face.end(), v) != face.end(); };
        if (!has(apices[0]) || !has(apices[1])) continue;
        TetReplacement3d replacement(mesh);
        applyFlip(replacement, *flip);
        changed = replacement.created();
        return true;
    }
    return false;
}

}  // namespace mesher
