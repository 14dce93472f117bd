#include "delaunay/facet_flip3d.h"

#include "delaunay/cavity_retriangulation.h"
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

std::optional<VertexId> clearBesideEdge(Triangulation3d& mesh, const std::array<VertexId, 2>& edge,
                                        RegionId region)
{
    const TetId at = mesh.findEdge(edge[0], edge[1]);
    if (!at.isValid()) return {};
    std::vector<TetId> tets;
    mesh.collectEdgeRing(at, edge[0], edge[1], tets);
    std::erase_if(tets, [&](TetId tet) { return mesh.region(tet) != region; });
    if (tets.size() <= 2 ||
        std::any_of(tets.begin(), tets.end(), [&](TetId t) { return mesh.isGhostTet(t); }))
        return {};
    CavityShell shell;
    for (const TetId tet : tets) {
        for (int face = 0; face < 4; ++face) {
            const TetFace outer = mesh.neighbour(tet, face);
            if (std::find(tets.begin(), tets.end(), outer.tet()) == tets.end())
                shell.add({mesh.faceVertices({tet, face}), outer});
        }
    }
    Vec3 point;
    if (!CavityRetriangulation(mesh).findKernelPoint(shell, point)) return {};
    const VertexId centre = mesh.addVertex(point);
    std::vector<TetCorners> after;
    for (const auto& [key, face] : shell.faces())
        after.push_back({face.corner[0], face.corner[1], face.corner[2], centre});
    TetReplacement3d replacement(mesh);
    replacement.replace(tets, after);
    if (const auto flip = evaluateFlip23(mesh, mesh.findFace(edge[0], edge[1], centre)))
        applyFlip(replacement, *flip);
    return centre;
}

}  // namespace mesher
