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
struct Orient3dEstimate
{
    Vec3 u;
    Vec3 v;
    Vec3 w;
    double determinant;

    Orient3dEstimate(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
        : u(b - a), v(c - a), w(d - a), determinant(dot(u, cross(v, w)))
    {
    }

    [[nodiscard]] double errorBound() const
    {
        const Vec3 largest = largestDifferences();
        return kOrient3dBound * largest.x * largest.y * largest.z;
    }
    /// Per axis.
    [[nodiscard]] Vec3 largestDifferences() const
    {
        return {std::max(std::max(std::abs(u.x), std::abs(v.x)), std::abs(w.x)),
                std::max(std::max(std::abs(u.y), std::abs(v.y)), std::abs(w.y)),
                std::max(std::max(std::abs(u.z), std::abs(v.z)), std::abs(w.z))};
    }
};

Sign orient3dExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The tiers behind the static filter. The error bound vanishes only if all points agree in one coordinate,
/// and then so does the determinant.
inline Sign orient3dFiltered(const Orient3dEstimate& estimate, const Vec3& a, const Vec3& b, const Vec3& c,
                             const Vec3& d)
{
    const double bound = estimate.errorBound();
    if (std::abs(estimate.determinant) > bound) return signOfNonZero(estimate.determinant);
    if (bound == 0.0) return Sign::Zero;
    return orient3dExact(a, b, c, d);
}

}  // namespace detail

/// Orientation of four points of space: the exact sign of det(b - a, c - a, d - a).
///
/// Sign       positive iff a, b, c turn counter-clockwise as seen from d
/// Laws       zero iff the points are coplanar; swapping two points flips the sign
/// Requires   points in the exact range (coordinate_range.h), a sound floating-point environment
/// Reference  [shewchuk1997] for the tiers; the exact tiers are our own (exact_tiers.h)
[[nodiscard]] inline Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const detail::Orient3dEstimate estimate(a, b, c, d);
    return detail::orient3dFiltered(estimate, a, b, c, d);
}

/// The same; `filter` must have been made for a box that contains the four points.
[[nodiscard]] inline Sign orient3d(const StaticFilter3d& filter, const Vec3& a, const Vec3& b, const Vec3& c,
                                   const Vec3& d)
{
    const detail::Orient3dEstimate estimate(a, b, c, d);
    if (std::abs(estimate.determinant) > filter.orient3d) return signOfNonZero(estimate.determinant);
    return detail::orient3dFiltered(estimate, a, b, c, d);
}

}  // namespace mesher
