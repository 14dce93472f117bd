#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>

namespace mesher {

/// The sizes that the options ask for on a model in space, as one field: the smallest of those of spaceSizes, on edges and
/// vertices, and `fromFiles` (may be none), not below the least size. Sizes of entities grow by distance / grading. Curvature
/// and sag are not in it: curves and faces are asked for theirs where they are sampled.
/// Requires     valid options
/// Refuses      a size on an entity that the model does not have
[[nodiscard]] Result<std::shared_ptr<const SizingField>>
solidSizes(const BrepModel& model, const MeshOptions& options, std::shared_ptr<const SizingField> fromFiles);

}  // namespace mesher
