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

/// The determinant in plain double arithmetic and what bounds its error. With the points relative to e and
/// their lifts, it is (|a|^2 b - |b|^2 a) . (c x d) + (|c|^2 d - |d|^2 c) . (a x b): two halves of one shape,
/// which are computed side by side.
struct InsphereEstimate
{
    VectorPair ac;
    VectorPair bd;
    DoublePair liftAC;
    DoublePair liftBD;
    double determinant;

    InsphereEstimate(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e)
        : ac(relative(a, c, e)),
          bd(relative(b, d, e)),
          liftAC(squaredLength(ac)),
          liftBD(squaredLength(bd)),
          determinant(evaluate())
    {
    }

    [[nodiscard]] static VectorPair relative(const Vec3& p, const Vec3& q, const Vec3& e)
    {
        return {DoublePair{p.x, q.x} - DoublePair{e.x, e.x}, DoublePair{p.y, q.y} - DoublePair{e.y, e.y},
                DoublePair{p.z, q.z} - DoublePair{e.z, e.z}};
    }

    [[nodiscard]] double evaluate() const
    {
        const VectorPair normals = cross(ac, bd);
        const DoublePair x = (liftAC * bd.x - liftBD * ac.x) * swapped(normals.x);
        const DoublePair y = (liftAC * bd.y - liftBD * ac.y) * swapped(normals.y);
        const DoublePair z = (liftAC * bd.z - liftBD * ac.z) * swapped(normals.z);
        const DoublePair halves = x + y + z;
        return halves[0] + halves[1];
    }

    [[nodiscard]] double errorBound() const
    {
        const DoublePair x = maximum(absolute(ac.x), absolute(bd.x));
        const DoublePair y = maximum(absolute(ac.y), absolute(bd.y));
        const DoublePair z = maximum(absolute(ac.z), absolute(bd.z));
        const DoublePair lift = maximum(liftAC, liftBD);
        const DoublePair xy = maximum(DoublePair{x[0], y[0]}, DoublePair{x[1], y[1]});
        const DoublePair zLift = maximum(DoublePair{z[0], lift[0]}, DoublePair{z[1], lift[1]});
        const DoublePair product = xy * zLift;
        return kInsphereBound * product[0] * product[1];
    }
    [[nodiscard]] double largestDifference() const
    {
        const DoublePair x = maximum(absolute(ac.x), absolute(bd.x));
        const DoublePair y = maximum(absolute(ac.y), absolute(bd.y));
        const DoublePair z = maximum(absolute(ac.z), absolute(bd.z));
        const DoublePair largest = maximum(x, maximum(y, z));
        return std::max(largest[0], largest[1]);
    }
};

Sign insphereExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);
Sign inspherePerturbation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

/// The tiers behind the static filter. The error bound vanishes only if all points agree in one coordinate,
/// and then so does the determinant.
inline Sign insphereFiltered(const InsphereEstimate& estimate, const Vec3& a, const Vec3& b, const Vec3& c,
                             const Vec3& d, const Vec3& e)
{
    const double bound = estimate.errorBound();
    if (std::abs(estimate.determinant) > bound) return signOfNonZero(estimate.determinant);
    if (bound == 0.0) return Sign::Zero;
    return insphereExact(a, b, c, d, e);
}

}  // namespace detail

/// Place of e with respect to the sphere through a, b, c, d; exact.
///
/// Sign       for positively oriented a, b, c, d (orient3d) positive iff e is strictly inside; for negatively
///            oriented ones the opposite
/// Laws       zero iff the points lie on one sphere or plane; swapping any two of the five flips the sign
/// Requires   points in the exact range (coordinate_range.h), a sound floating-point environment
/// Reference  [shewchuk1997] for the tiers; the exact tiers are our own (exact_tiers.h)
[[nodiscard]] inline Sign insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e)
{
    const detail::InsphereEstimate estimate(a, b, c, d, e);
    return detail::insphereFiltered(estimate, a, b, c, d, e);
}

/// The same; `filter` must have been made for a box that contains the five points.
[[nodiscard]] inline Sign insphere(const StaticFilter3d& filter, const Vec3& a, const Vec3& b, const Vec3& c,
                                   const Vec3& d, const Vec3& e)
{
    const detail::InsphereEstimate estimate(a, b, c, d, e);
    if (std::abs(estimate.determinant) > filter.insphere) return signOfNonZero(estimate.determinant);
    return detail::insphereFiltered(estimate, a, b, c, d, e);
}

/// `insphere` of points whose lifts are raised by infinitesimals, that of the lexicographically larger point
/// being infinitely larger than that of the smaller one. It depends on the coordinates only, so the Delaunay
/// triangulation it defines is unique.
///
/// Sign       that of `insphere` where it is not zero; else of the first non-zero term, going from the
///            lexicographically largest point to the smallest: for e the term is -orient3d(a, b, c, d), for
///            one of a, b, c, d it is orient3d(a, b, c, d) with e in that point's place
/// Laws       zero iff all five points are coplanar or two of them coincide; swapping any two flips the sign
/// Requires   as `insphere`
/// Reference  [devillers2011] section 3
[[nodiscard]] inline Sign inspherePerturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                            const Vec3& e)
{
    const Sign sign = insphere(a, b, c, d, e);
    return sign != Sign::Zero ? sign : detail::inspherePerturbation(a, b, c, d, e);
}

/// The same; `filter` must have been made for a box that contains the five points.
[[nodiscard]] inline Sign inspherePerturbed(const StaticFilter3d& filter, const Vec3& a, const Vec3& b,
                                            const Vec3& c, const Vec3& d, const Vec3& e)
{
    const Sign sign = insphere(filter, a, b, c, d, e);
    return sign != Sign::Zero ? sign : detail::inspherePerturbation(a, b, c, d, e);
}

}  // namespace mesher
