#pragma once

#include "base/vec.h"
#include "predicates/error_bounds.h"
#include "predicates/sign.h"
#include "predicates/static_filter.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace detail {

/// The determinant in plain double arithmetic and what bounds its error. Laplace expansion along the column
/// pairs (x, y) and (z, lift): six products of two-by-two minors.
struct InsphereEstimate
{
    Vec3 a;
    Vec3 b;
    Vec3 c;
    Vec3 d;
    double liftA;
    double liftB;
    double liftC;
    double liftD;
    double determinant;

    InsphereEstimate(const Vec3& pa, const Vec3& pb, const Vec3& pc, const Vec3& pd, const Vec3& e)
        : a(pa - e), b(pb - e), c(pc - e), d(pd - e), liftA(squaredLength(a)), liftB(squaredLength(b)),
          liftC(squaredLength(c)), liftD(squaredLength(d)), determinant(laplace())
    {}

    [[nodiscard]] double laplace() const
    {
        const double ab = (a.x * b.y - a.y * b.x) * (d.z * liftC - c.z * liftD);
        const double ac = (a.x * c.y - a.y * c.x) * (b.z * liftD - d.z * liftB);
        const double ad = (a.x * d.y - a.y * d.x) * (c.z * liftB - b.z * liftC);
        const double bc = (b.x * c.y - b.y * c.x) * (d.z * liftA - a.z * liftD);
        const double bd = (b.x * d.y - b.y * d.x) * (a.z * liftC - c.z * liftA);
        const double cd = (c.x * d.y - c.y * d.x) * (b.z * liftA - a.z * liftB);
        return ((ab + ac) + (ad + bc)) + (bd + cd);
    }

    [[nodiscard]] double errorBound() const
    {
        const double x = std::max(std::max(std::abs(a.x), std::abs(b.x)), std::max(std::abs(c.x), std::abs(d.x)));
        const double y = std::max(std::max(std::abs(a.y), std::abs(b.y)), std::max(std::abs(c.y), std::abs(d.y)));
        const double z = std::max(std::max(std::abs(a.z), std::abs(b.z)), std::max(std::abs(c.z), std::abs(d.z)));
        const double lift = std::max(std::max(liftA, liftB), std::max(liftC, liftD));
        return kInsphereBound * (x * y) * (z * lift);
    }
};

Sign insphereExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);
Sign inspherePerturbation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

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
    if (std::abs(estimate.determinant) > estimate.errorBound()) return signOfNonZero(estimate.determinant);
    return detail::insphereExact(a, b, c, d, e);
}

/// The same; `filter` must have been made for a box that contains the five points.
[[nodiscard]] inline Sign insphere(const StaticFilter3d& filter, const Vec3& a, const Vec3& b, const Vec3& c,
                                   const Vec3& d, const Vec3& e)
{
    const detail::InsphereEstimate estimate(a, b, c, d, e);
    if (std::abs(estimate.determinant) > filter.insphere) return signOfNonZero(estimate.determinant);
    if (std::abs(estimate.determinant) > estimate.errorBound()) return signOfNonZero(estimate.determinant);
    return detail::insphereExact(a, b, c, d, e);
}

/// `insphere` of points whose lifts are raised by infinitesimals, that of the lexicographically larger point
/// being infinitely larger than that of the smaller one. It depends on the coordinates only, so the Delaunay
/// triangulation it defines is unique.
///
/// Sign       that of `insphere` where it is not zero; else of the first non-zero term, going from the
///            lexicographically largest point to the smallest: for e the term is -orient3d(a, b, c, d), for one
///            of a, b, c, d it is orient3d(a, b, c, d) with e in that point's place
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
