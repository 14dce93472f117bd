#pragma once

#include "base/vec.h"
#include "predicates/error_bounds.h"
#include "predicates/sign.h"
#include "predicates/static_filter.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace detail {

/// The determinant in plain double arithmetic and what bounds its error.
struct Orient2dEstimate
{
    Vec2 u;
    Vec2 v;
    double determinant;

    Orient2dEstimate(const Vec2& a, const Vec2& b, const Vec2& c)
        : u(b - a), v(c - a), determinant(cross(u, v))
    {
    }

    [[nodiscard]] double errorBound() const
    {
        const Vec2 largest = largestDifferences();
        return kOrient2dBound * largest.x * largest.y;
    }
    /// Per axis.
    [[nodiscard]] Vec2 largestDifferences() const
    {
        return {std::max(std::abs(u.x), std::abs(v.x)), std::max(std::abs(u.y), std::abs(v.y))};
    }
};

Sign orient2dExact(const Vec2& a, const Vec2& b, const Vec2& c);

/// The tiers behind the static filter. The error bound vanishes only if all points agree in one coordinate,
/// and then so does the determinant.
inline Sign orient2dFiltered(const Orient2dEstimate& estimate, const Vec2& a, const Vec2& b, const Vec2& c)
{
    const double bound = estimate.errorBound();
    if (std::abs(estimate.determinant) > bound) return signOfNonZero(estimate.determinant);
    if (bound == 0.0) return Sign::Zero;
    return orient2dExact(a, b, c);
}

}  // namespace detail

/// Orientation of three points of the plane: the exact sign of det(b - a, c - a).
///
/// Sign       positive iff a, b, c turn counter-clockwise
/// Laws       zero iff the points are collinear; swapping two points flips the sign; rotating them keeps it
/// Requires   points in the exact range (coordinate_range.h), a sound floating-point environment
/// Reference  [shewchuk1997] for the tiers; the exact tiers are our own (exact_tiers.h)
[[nodiscard]] inline Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const detail::Orient2dEstimate estimate(a, b, c);
    return detail::orient2dFiltered(estimate, a, b, c);
}

/// The same; `filter` must have been made for a box that contains the three points.
[[nodiscard]] inline Sign orient2d(const StaticFilter2d& filter, const Vec2& a, const Vec2& b, const Vec2& c)
{
    const detail::Orient2dEstimate estimate(a, b, c);
    if (std::abs(estimate.determinant) > filter.orient2d) return signOfNonZero(estimate.determinant);
    return detail::orient2dFiltered(estimate, a, b, c);
}

}  // namespace mesher
