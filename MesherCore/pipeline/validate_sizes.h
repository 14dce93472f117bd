#pragma once

#include "base/result.h"
#include "pipeline/mesh_options.h"

namespace mesher {

/// The part of `validate` that concerns sizes: lengths that are none, boxes and balls that are no shapes, formulas that cannot be
/// read; the error names the option.
[[nodiscard]] Result<void> validateSizes(const MeshOptions& options);

}  // namespace mesher
