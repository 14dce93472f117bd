#pragma once

#include "base/result.h"
#include "base/run_context.h"
#include "brep/brep_model.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>

namespace mesher {

/// The sizes that the options ask for on a model in space, as one field: the smallest of those of spaceSizes, in solids, on
/// faces, edges and vertices, and `fromFiles` (may be none), not below the least size. Sizes of entities hold on all of the
/// entity, and grow from there by distance / grading. Curvature and sag are not in it: curves and faces are asked for theirs
/// where they are sampled.
/// Requires     valid options
/// Refuses      a size on an entity that the model does not have, or on a face that cannot be sampled
/// Cost         a coarse sample of each face and solid that has a size of its own
[[nodiscard]] Result<std::shared_ptr<const SizingField>>
solidSizes(const BrepModel& model, const MeshOptions& options, std::shared_ptr<const SizingField> fromFiles,
           RunContext& context);

}  // namespace mesher
