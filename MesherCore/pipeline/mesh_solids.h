#pragma once

#include "base/run_context.h"
#include "brep/brep_model.h"
#include "pipeline/estimate.h"
#include "pipeline/mesh_options.h"
#include "pipeline/mesh_outcome.h"
#include "sizing/sizing_field.h"

#include <memory>
#include <vector>

namespace mesher {

/// Meshes the solids of a model: samples its curves and faces, builds the constrained Delaunay tetrahedralization, refines it,
/// classifies and reports. A face between two solids is meshed once.
/// Guarantees   a failure names its entity
/// Refuses      a model without solids, shells that are open or overlap, and what solidSizes refuses; elements of second order,
///              which are not there yet; what is expected to exceed the elements allowed by far
/// Terminates   the limit on time holds for the run as a whole, that on elements for each group of solids that share nothing
[[nodiscard]] MeshOutcome meshSolids(const BrepModel& model, const MeshOptions& options,
                                     std::shared_ptr<const SizingField> fromFiles, RunContext& context);

/// What meshSolids is going to take.
/// Refuses      a model without solids, shells that are open, and what solidSizes refuses
/// Terminates   early when the run is to end; the estimate is worth nothing then
[[nodiscard]] Result<MeshEstimate> estimateSolidModel(const BrepModel& model, const MeshOptions& options,
                                                      std::shared_ptr<const SizingField> fromFiles,
                                                      RunContext& context);

/// Meshes faces of a model as surfaces in space, those that share edges as one surface.
[[nodiscard]] MeshOutcome meshFaces(const BrepModel& model, const std::vector<BrepFaceId>& faces,
                                    const MeshOptions& options, std::shared_ptr<const SizingField> fromFiles,
                                    RunContext& context);

}  // namespace mesher
