#include "predicates/insphere.h"

#include "base/assert.h"
#include "predicates/coordinate_range.h"
#include "predicates/exact_tiers.h"
#include "predicates/expansion_determinants.h"
#include "predicates/flat_coordinates.h"
#include "predicates/integer_determinants.h"
#include "predicates/orient3d.h"
#include "predicates/short_coordinates.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mesher::detail {

namespace {

/// Bits of the differences for which all sums stay below 2^53: 72 terms of at most 2^(5 * 9) each.
constexpr int kShortBits = 9;

}  // namespace

std::optional<Sign> insphereShort(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e)
{
    const InsphereEstimate estimate(a, b, c, d, e);
    const double difference = estimate.largestDifference();
    if (!areShort(flatCoordinates(a, b, c, d, e), difference, kShortBits)) return std::nullopt;
    return signOf(estimate.determinant);
}

std::optional<Sign> insphereInteger64(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                      const Vec3& e)
{
    const auto grid = toGrid64(flatCoordinates(a, b, c, d, e));
    if (!grid) return std::nullopt;
    return gridInsphere(*grid);
}

std::optional<Sign> insphereInteger128(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                       const Vec3& e)
{
    const auto grid = toGrid128(flatCoordinates(a, b, c, d, e));
    if (!grid) return std::nullopt;
    return gridInsphere(*grid);
}

Sign insphereExpansion(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e)
{
    return expansionInsphere(a, b, c, d, e).sign();
}

Sign insphereExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e)
{
    MESHER_PRECONDITION(isInExactRange(a) && isInExactRange(b) && isInExactRange(c) && isInExactRange(d) &&
                        isInExactRange(e));
    if (const auto sign = insphereShort(a, b, c, d, e)) return *sign;
    if (const auto sign = insphereInteger64(a, b, c, d, e)) return *sign;
    if (const auto sign = insphereInteger128(a, b, c, d, e)) return *sign;
    return insphereExpansion(a, b, c, d, e);
}

namespace {

/// The coefficient of the infinitesimal by which the lift of the point number `index` is raised.
Sign liftCoefficient(std::array<const Vec3*, 5> points, std::size_t index)
{
    constexpr std::size_t kLast = 4;
    const bool isLast = index == kLast;
    points[index] = points[kLast];
    const Sign orientation = orient3d(*points[0], *points[1], *points[2], *points[3]);
    return isLast ? -orientation : orientation;
}

}  // namespace

Sign inspherePerturbation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e)
{
    const std::array<const Vec3*, 5> points{&a, &b, &c, &d, &e};
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
    std::sort(order.begin(), order.end(), [&points](std::size_t i, std::size_t j) {
        return isLexicographicallyLess(*points[j], *points[i]);
    });
    // Coinciding points have the same lift, which makes two rows of the determinant equal.
    for (std::size_t i = 0; i + 1 < 5; ++i) {
        if (*points[order[i]] == *points[order[i + 1]]) return Sign::Zero;
    }
    for (const std::size_t index : order) {
        const Sign sign = liftCoefficient(points, index);
        if (sign != Sign::Zero) return sign;
    }
    return Sign::Zero;
}

}  // namespace mesher::detail
