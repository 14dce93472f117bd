#pragma once

#include "base/vec.h"
#include "predicates/error_bounds.h"
#include "predicates/sign.h"
#include "predicates/static_filter.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace detail {

/// The determinant in plain double arithmetic and what bounds its error. It is evaluated as a comparison of
/// the angles under which c and d see the chord ab, which takes fewer operations than the lifted determinant
/// and is algebraically the same.
struct IncircleEstimate
{
    Vec2 ca;
    Vec2 cb;
    Vec2 da;
    Vec2 db;
    double determinant;

    IncircleEstimate(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
        : ca(a - c),
          cb(b - c),
          da(a - d),
          db(b - d),
          determinant(dot(ca, cb) * cross(da, db) - cross(ca, cb) * dot(da, db))
    {
    }

    [[nodiscard]] double errorBound() const
    {
        const Vec2 largest = largestDifferences();
        return kIncircleBound * largest.x * largest.y * squaredLength(largest);
    }
    /// Per axis.
    [[nodiscard]] Vec2 largestDifferences() const
    {
        return {std::max(std::max(std::abs(ca.x), std::abs(cb.x)), std::max(std::abs(da.x), std::abs(db.x))),
                std::max(std::max(std::abs(ca.y), std::abs(cb.y)), std::max(std::abs(da.y), std::abs(db.y)))};
    }
};

Sign incircleExact(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
Sign incirclePerturbation(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// The tiers behind the static filter. The error bound vanishes only if all points agree in one coordinate,
/// and then so does the determinant.
inline Sign incircleFiltered(const IncircleEstimate& estimate, const Vec2& a, const Vec2& b, const Vec2& c,
                             const Vec2& d)
{
    const double bound = estimate.errorBound();
    if (std::abs(estimate.determinant) > bound) return signOfNonZero(estimate.determinant);
    if (bound == 0.0) return Sign::Zero;
    return incircleExact(a, b, c, d);
}

}  // namespace detail

/// Place of d with respect to the circle through a, b, c; exact.
///
/// Sign       for counter-clockwise a, b, c positive iff d is strictly inside; for clockwise ones the
///            opposite
/// Laws       zero iff the points lie on one circle or line; swapping any two of the four flips the sign
/// Requires   points in the exact range (coordinate_range.h), a sound floating-point environment
/// Reference  [shewchuk1997] for the tiers; the exact tiers are our own (exact_tiers.h)
[[nodiscard]] inline Sign incircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const detail::IncircleEstimate estimate(a, b, c, d);
    return detail::incircleFiltered(estimate, a, b, c, d);
}

/// The same; `filter` must have been made for a box that contains the four points.
[[nodiscard]] inline Sign incircle(const StaticFilter2d& filter, const Vec2& a, const Vec2& b, const Vec2& c,
                                   const Vec2& d)
{
    const detail::IncircleEstimate estimate(a, b, c, d);
    if (std::abs(estimate.determinant) > filter.incircle) return signOfNonZero(estimate.determinant);
    return detail::incircleFiltered(estimate, a, b, c, d);
}

/// `incircle` of points whose lifts are raised by infinitesimals, that of the lexicographically larger point
/// being infinitely larger than that of the smaller one. It depends on the coordinates only, so the Delaunay
/// triangulation it defines is unique.
///
/// Sign       that of `incircle` where it is not zero; else of the first non-zero term, going from the
///            lexicographically largest point to the smallest: for d the term is -orient2d(a, b, c), for one
///            of a, b, c it is orient2d(a, b, c) with d in that point's place
/// Laws       zero iff all four points are collinear or two of them coincide; swapping any two flips the sign
/// Requires   as `incircle`
/// Reference  [devillers2011] section 3
[[nodiscard]] inline Sign incirclePerturbed(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const Sign sign = incircle(a, b, c, d);
    return sign != Sign::Zero ? sign : detail::incirclePerturbation(a, b, c, d);
}

/// The same; `filter` must have been made for a box that contains the four points.
[[nodiscard]] inline Sign incirclePerturbed(const StaticFilter2d& filter, const Vec2& a, const Vec2& b,
                                            const Vec2& c, const Vec2& d)
{
    const Sign sign = incircle(filter, a, b, c, d);
    return sign != Sign::Zero ? sign : detail::incirclePerturbation(a, b, c, d);
}

}  // namespace mesher
