#include "pipeline/improve_solids.h"

#include "surface_sampling/facet_intersections.h"

#include <algorithm>
#include <utility>

namespace mesher {

namespace {

/// Triangles keep their order; the nodes of those that have changed are others or elsewhere.
FacetMarks changedTriangles(const ClassifiedMesh& before, const ClassifiedMesh& mesh)
{
    FacetMarks isChanged;
    isChanged.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& was = before.triangles[i].node;
        const auto& is = mesh.triangles[i].node;
        const bool isSame = std::equal(is.begin(), is.end(), was.begin(), [&](NodeId a, NodeId b) {
            return mesh.nodes[a].position == before.nodes[b].position;
        });
        isChanged.push_back(isSame ? 0 : 1);
    }
    return isChanged;
}

/// The triangles that refinement left are faces of one tetrahedralization, so only those that have changed can meet others.
bool meetsItself(const BrepModel& model, const ClassifiedMesh& before, const ClassifiedMesh& mesh,
                 RunContext& context)
{
    SurfaceMesh surface;
    surface.nodes = mesh.nodes;
    for (const auto& triangle : mesh.triangles)
        surface.facets.push_back({triangle.node, BrepFaceId(triangle.entity.index), {}});
    return !findFacetIntersections(model, surface, changedTriangles(before, mesh), context).empty();
}

}  // namespace

Result<SolidImprovement> improveSolids(ClassifiedMesh& mesh, const BrepModel& model,
                                       const ImprovementOptions& options, RunContext& context)
{
    ClassifiedMesh before = mesh;
    SolidImprovement result;
    Result<Improvement> improved = improveMesh(mesh, model, options, context);
    if (!improved) return improved.error();
    if (improved->counts.curvedChanges > 0 && meetsItself(model, before, mesh, context)) {
        result.isBoundaryFrozen = true;
        mesh = std::move(before);
        ImprovementOptions inside = options;
        inside.boundary = BoundaryChanges::None;
        improved = improveMesh(mesh, model, inside, context);
        if (!improved) return improved.error();
    }
    result.improvement = improved.value();
    return result;
}

}  // namespace mesher
