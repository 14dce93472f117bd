#pragma once

#include "base/box.h"
#include "base/vec.h"

#include <cstdint>
#include <optional>
#include <span>

namespace mesher {

/// The exact range: coordinates that are multiples of 2^kGridExponent of magnitude at most 2^kLargestExponent.
/// There no sum, product or expansion of the predicates overflows, and each product of up to five coordinates
/// or differences is a multiple of 2^-1000, hence exact or rounded with a relative error of one roundoff.
inline constexpr int kLargestExponent = 200;
inline constexpr int kGridExponent = -200;

/// False also for NaN and infinities.
[[nodiscard]] bool isInExactRange(const Vec2& p);
[[nodiscard]] bool isInExactRange(const Vec3& p);

}  // namespace mesher
