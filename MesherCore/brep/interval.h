#pragma once

#include <algorithm>

namespace mesher {

/// A closed range of a parameter.
struct Interval
{
    double first = 0.0;
    double last = 0.0;

    [[nodiscard]] constexpr double length() const { return last - first; }
    [[nodiscard]] constexpr bool contains(double t) const { return first <= t && t <= last; }
    [[nodiscard]] constexpr double clamp(double t) const { return std::clamp(t, first, last); }
    /// The parameter a fraction of the way from first to last.
    [[nodiscard]] constexpr double at(double fraction) const { return first + fraction * (last - first); }
    friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace mesher
