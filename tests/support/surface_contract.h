#pragma once

#include "brep/surface.h"

#include <string>
#include <vector>

namespace mesher::test {

/// What every surface of every backend promises within a window of its parameters, tried at points drawn with a fixed seed:
/// one line per broken promise. `size` is the size of the model, `trials` the number of points.
[[nodiscard]] std::vector<std::string> findBrokenPromises(const Surface& surface, Interval u, Interval v, double size,
                                                          int trials);

}  // namespace mesher::test
