#pragma once

#include "base/result.h"
#include "base/run_context.h"
#include "brep/brep_model.h"
#include "pipeline/estimate.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>

namespace mesher {

/// What meshModel is going to take: of dimension 3 for the solids, of dimension 2 for faces of one plane.
/// Requires     `fromFiles` as for meshModel
/// Terminates   early when the context or the time of the options ends it; `context.stopReason()` tells, and the estimate is
///              worth nothing then
/// Refuses      senseless options, curved faces of dimension 2, and what estimateSolidModel and planarModel refuse
[[nodiscard]] Result<MeshEstimate> estimateModel(const BrepModel& model, const MeshOptions& options,
                                                 std::shared_ptr<const SizingField> fromFiles,
                                                 RunContext& context);

}  // namespace mesher
