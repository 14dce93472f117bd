#pragma once

#include "base/vec.h"
#include "predicates/double_pair.h"
#include "predicates/error_bounds.h"
#include "predicates/sign.h"
#include "predicates/static_filter.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace detail {

/// The determinant in plain double arithmetic and what bounds its error. The three positive products of the rule
/// of Sarrus are summed in one half of a vector register and the three negative ones in the other.
struct Orient3dEstimate
{
    DoublePair uXY;
    DoublePair vXY;
    DoublePair wXY;
    double uZ;
    double vZ;
    double wZ;
    double determinant;

    Orient3dEstimate(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
        : uXY(loadXY(b) - loadXY(a)),
          vXY(loadXY(c) - loadXY(a)),
          wXY(loadXY(d) - loadXY(a)),
          uZ(b.z - a.z),
          vZ(c.z - a.z),
          wZ(d.z - a.z),
          determinant(evaluate())
    {
    }

    [[nodiscard]] double evaluate() const
    {
        const DoublePair uvw = both(uZ) * (vXY * swapped(wXY));
        const DoublePair vwu = both(vZ) * (wXY * swapped(uXY));
        const DoublePair wuv = both(wZ) * (uXY * swapped(vXY));
        const DoublePair halves = uvw + vwu + wuv;
        return halves[0] - halves[1];
    }

    [[nodiscard]] double errorBound() const
    {
        const Vec3 largest = largestDifferences();
        return kOrient3dBound * largest.x * largest.y * largest.z;
    }
    /// Per axis.
    [[nodiscard]] Vec3 largestDifferences() const
    {
        const DoublePair xy = maximum(maximum(absolute(uXY), absolute(vXY)), absolute(wXY));
        return {xy[0], xy[1], std::max(std::max(std::abs(uZ), std::abs(vZ)), std::abs(wZ))};
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
