#pragma once

#include <cmath>

namespace mesher {

/// value + k period in [start, start + period).
[[nodiscard]] inline double wrapInto(double value, double start, double period)
{
    const double turns = std::floor((value - start) / period);
    const double wrapped = value - turns * period;
    if (wrapped < start) return wrapped + period;
    return wrapped < start + period ? wrapped : start;
}

/// value + k period nearest to the target.
[[nodiscard]] inline double wrapNear(double value, double target, double period)
{
    return value + period * std::round((target - value) / period);
}

}  // namespace mesher
