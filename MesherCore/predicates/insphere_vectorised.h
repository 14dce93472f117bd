#pragma once

#include "predicates/error_bounds.h"

#include <cmath>

namespace mesher {

/// The determinant of insphere, rounded, and the largest computed squared distance to the last point.
struct InsphereVectorEstimate
{
    double determinant;
    double largestLift;

    /// A determinant of larger magnitude has the right sign. The coordinate differences are not larger than
    /// the root of the largest lift; the roundings here are among those that kInsphereBound allows for.
    [[nodiscard]] double errorBound() const
    {
        return detail::kInsphereBound * (largestLift * largestLift) * std::sqrt(largestLift);
    }
};

/// Whether this processor can run insphereEstimateVectorised. Ask once, outside of loops.
[[nodiscard]] bool canVectoriseInsphere();

/// The determinant of insphere in plain double arithmetic by 256-bit vectors, about twice as fast as one at a
/// time. It is the Laplace expansion of insphere.h summed in a tree of the same depth, so its rounding error
/// has the same bound and StaticFilter3d::insphere or errorBound() decides on it. What it decides is exact;
/// so a result never depends on the processor. Each argument points to four doubles aligned to 32 bytes, of
/// which the fourth is not used.
/// Requires   canVectoriseInsphere()
[[nodiscard]] InsphereVectorEstimate insphereEstimateVectorised(const double* a, const double* b,
                                                                const double* c, const double* d,
                                                                const double* e);

}  // namespace mesher
