#pragma once

#include "base/result.h"
#include "base/run_context.h"
#include "brep/brep_model.h"
#include "improvement/improve_mesh.h"
#include "mesh/classified_mesh.h"

namespace mesher {

struct SolidImprovement
{
    Improvement improvement;
    /// Triangles that had moved met others, so that the boundary was left as it was.
    bool isBoundaryFrozen = false;
};

/// Improves a mesh of solids, and again without touching its boundary if that has come to meet itself: improvement does not look
/// across what is outside of all solids.
/// Cost         that of improveMesh, and a search for intersections of the boundary; a copy of the mesh
[[nodiscard]] Result<SolidImprovement> improveSolids(ClassifiedMesh& mesh, const BrepModel& model,
                                                     const ImprovementOptions& options, RunContext& context);

}  // namespace mesher
