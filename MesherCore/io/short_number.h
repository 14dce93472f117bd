#pragma once

#include <cstddef>
#include <string>

namespace mesher {

/// The number as decimal text of at most `width` characters, for readers that cut what is longer: the same double when it is
/// read if that is possible, else with the least loss.
/// Requires  a finite value, 10 <= width <= 24
[[nodiscard]] std::string shortNumber(double value, std::size_t width);

}  // namespace mesher
