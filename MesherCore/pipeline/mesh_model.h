#pragma once

#include "base/run_context.h"
#include "brep/brep_model.h"
#include "mesh/classified_mesh.h"
#include "mesh/curved_boundary.h"
#include "pipeline/mesh_options.h"
#include "pipeline/mesh_report.h"
#include "sizing/sizing_field.h"

#include <memory>
#include <optional>

namespace mesher {

struct MeshOutcome
{
    /// What was meshed; also when a limit ended the run, but not when it failed.
    std::optional<ClassifiedMesh> mesh;
    /// Of meshes of dimension 2.
    std::optional<CurvedBoundary> curvedBoundary;
    MeshReport report;
};

/// Meshes a model as the options say: the one function that programs and people call, whatever the dimension.
/// Guarantees   those of meshPlanar and meshSolids; the report says why there is no mesh, or not the whole one
/// Requires     `background`: the sizes of options.background, or none
/// Refuses      options out of range; what would surely need more elements than the options allow
/// Terminates   within the limits of the options, with the reason
[[nodiscard]] MeshOutcome meshModel(const BrepModel& model, const MeshOptions& options,
                                    std::shared_ptr<const SizingField> background, int boundaryOrder,
                                    RunContext& context);

}  // namespace mesher
