#pragma once

#include "brep/curve.h"

#include <string>
#include <vector>

namespace mesher::test {

/// What every curve of every backend promises, tried at parameters drawn with a fixed seed: one line per broken promise.
/// `size` is the size of the model the curve belongs to.
[[nodiscard]] std::vector<std::string> findBrokenPromises(const Curve& curve, Interval part, double size);

}  // namespace mesher::test
