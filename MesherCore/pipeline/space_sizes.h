#pragma once

#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>
#include <vector>

namespace mesher {

/// The sizes that the options ask for at places of space rather than on entities of a model: the uniform one, those in boxes and
/// balls, and the formula.
/// Requires     valid options
[[nodiscard]] std::vector<std::shared_ptr<const SizingField>> spaceSizes(const MeshOptions& options);

}  // namespace mesher
