#pragma once

#include "base/vec.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace mesher::test {

/// Random segments of the unit square, pairwise disjoint, their lengths from 1/4000 to 1/2 and log-uniform before the
/// crossing ones were dropped.
std::vector<std::pair<Vec2, Vec2>> nonCrossingSegments(std::size_t count, std::uint64_t seed);

}  // namespace mesher::test
