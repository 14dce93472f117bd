#pragma once

#include "base/result.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>

namespace mesher {

/// The smallest of the sizes in the files that the options name: the background mesh and the points; none without such files.
/// Sizes of points grow by distance / grading.
/// Refuses      files that cannot be read or hold no sizes, by their names
[[nodiscard]] Result<std::shared_ptr<const SizingField>> readSizeFiles(const MeshOptions& options);

}  // namespace mesher
