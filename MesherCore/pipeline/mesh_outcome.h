#pragma once

#include "mesh/classified_mesh.h"
#include "mesh/curved_boundary.h"
#include "pipeline/mesh_report.h"

#include <optional>

namespace mesher {

struct MeshOutcome
{
    /// What was meshed. Of a run that did not end as it should, what there is: the mesh so far when a limit ended it, of solids
    /// without a volume mesh the surface.
    std::optional<ClassifiedMesh> mesh;
    /// Of plane meshes.
    std::optional<CurvedBoundary> curvedBoundary;
    MeshReport report;
};

}  // namespace mesher
