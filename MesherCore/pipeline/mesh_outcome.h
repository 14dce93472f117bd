#pragma once

#include "mesh/classified_mesh.h"
#include "mesh/curved_boundary.h"
#include "pipeline/mesh_report.h"

#include <optional>

namespace mesher {

struct MeshOutcome
{
    /// What was meshed; also when a limit ended the run, but not when it failed.
    std::optional<ClassifiedMesh> mesh;
    /// Of plane meshes.
    std::optional<CurvedBoundary> curvedBoundary;
    MeshReport report;
};

}  // namespace mesher
