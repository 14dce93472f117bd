#include "pipeline/improve_solids.h"

#include "surface_sampling/facet_intersections.h"

#include <utility>

namespace mesher {

namespace {

bool meetsItself(const BrepModel& model, const ClassifiedMesh& mesh, RunContext& context)
{
    SurfaceMesh surface;
    surface.nodes = mesh.nodes;
    for (const auto& triangle : mesh.triangles)
        surface.facets.push_back({triangle.node, BrepFaceId(triangle.entity.index), {}});
    return !findFacetIntersections(model, surface, context).empty();
}

}  // namespace

Result<SolidImprovement> improveSolids(ClassifiedMesh& mesh, const BrepModel& model,
                                       const ImprovementOptions& options, RunContext& context)
{
    ClassifiedMesh before = mesh;
    SolidImprovement result;
    Result<Improvement> improved = improveMesh(mesh, model, options, context);
    if (!improved) return improved.error();
    if (improved->counts.curvedChanges > 0 && meetsItself(model, mesh, context)) {
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
