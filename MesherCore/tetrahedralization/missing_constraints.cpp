#include "tetrahedralization/missing_constraints.h"

#include <algorithm>

namespace mesher {

namespace {

/// Locks each face that is a facet; the others stay to be found.
std::vector<char> lockFacesThatAreFacets(SurfaceConstraints& constraints)
{
    ConstrainedTetrahedralization& tets = constraints.tets();
    Triangulation3d& mesh = tets.mesh();
    const SurfaceMesh& surface = constraints.surface();
    std::vector<char> isPresent(surface.facets.size(), 0);
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet) || mesh.isGhostTet(tet)) continue;
        for (int face = 0; face < 4; ++face) {
            const TetFace side(tet, face);
            if (mesh.neighbour(side).tet() < tet) continue;
            auto corner = mesh.faceVertices(side);
            std::sort(corner.begin(), corner.end());
            const FacetId* facet = tets.facetOf.find(corner);
            if (facet == nullptr) continue;
            mesh.setFaceConstrained(side, true);
            isPresent[facet->value] = 1;
        }
    }
    return isPresent;
}

void mapFacets(SurfaceConstraints& constraints)
{
    ConstrainedTetrahedralization& tets = constraints.tets();
    const SurfaceMesh& surface = constraints.surface();
    tets.facetOf.reserve(surface.facets.size());
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        if (!surface.facets[FacetId(i)].isAlive()) continue;
        auto corner = constraints.cornersOf(FacetId(i));
        std::sort(corner.begin(), corner.end());
        tets.facetOf.insert(corner, FacetId(i));
    }
}

}  // namespace

void findMissingConstraints(SurfaceConstraints& constraints)
{
    const SurfaceMesh& surface = constraints.surface();
    mapFacets(constraints);
    const std::vector<char> isPresent = lockFacesThatAreFacets(constraints);
    for (std::uint32_t i = 0; i < surface.segments.size(); ++i) {
        if (surface.segments[SegmentId(i)].isAlive()) constraints.require(SegmentId(i));
    }
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        if (surface.facets[FacetId(i)].isAlive() && isPresent[i] == 0) constraints.require(FacetId(i));
    }
    // An edge comes once for each facet at it.
    std::vector<EdgeKey>& edges = constraints.missingEdges;
    IndexedMap<EdgeKey, char> seen;
    std::erase_if(edges, [&](const EdgeKey& edge) { return !seen.insert(edge, 1).second; });
}

}  // namespace mesher
