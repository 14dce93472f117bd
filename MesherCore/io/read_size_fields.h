#pragma once

#include "base/result.h"
#include "io/read_size_points.h"
#include "sizing/sizing_field.h"

#include <memory>
#include <string>
#include <vector>

namespace mesher {

/// A mesh file with one number at each node, the size.
/// Refuses      files that cannot be read or hold no sizes, by their names
[[nodiscard]] Result<std::shared_ptr<const SizingField>> readBackgroundField(const std::string& path);

/// Sizes at points, growing by distance / grading.
[[nodiscard]] std::shared_ptr<const SizingField> fieldOfPoints(const std::vector<SizePoint>& points,
                                                               double grading);

/// The smallest of the sizes in two files, of which either may be empty: a background mesh, and points. None without files.
/// Refuses      files that cannot be read or hold no sizes, by their names
[[nodiscard]] Result<std::shared_ptr<const SizingField>>
readSizeFields(const std::string& background, const std::string& points, double grading);

}  // namespace mesher
