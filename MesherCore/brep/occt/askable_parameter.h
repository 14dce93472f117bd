#pragma once

#include "brep/analytic/periodic.h"
#include "brep/interval.h"

#include <algorithm>
#include <cmath>

namespace mesher {

/// The parameter at which the kernel is asked in place of `value`. Newton steps near a pole leap over millions of periods or far out of
/// the range, where the kernel counts its way back period by period, or finds no span; within one length of the range on both sides
/// it answers well. A value that is not finite stays: it must not be asked at all.
[[nodiscard]] inline double askableParameter(double value, Interval range, double period)
{
    if (!std::isfinite(value) || !std::isfinite(range.first) || !std::isfinite(range.last)) return value;
    const double low = range.first - range.length(), high = range.last + range.length();
    if (low <= value && value <= high) return value;
    return period > 0.0 ? wrapInto(value, range.first, period) : std::clamp(value, low, high);
}

}  // namespace mesher
