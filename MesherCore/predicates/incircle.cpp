#include "predicates/incircle.h"

#include "base/assert.h"
#include "predicates/coordinate_range.h"
#include "predicates/exact_tiers.h"
#include "predicates/expansion_determinants.h"
#include "predicates/flat_coordinates.h"
#include "predicates/integer_determinants.h"
#include "predicates/orient2d.h"
#include "predicates/short_coordinates.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mesher::detail {

namespace {

/// Bits of the differences for which all sums stay below 2^53: the two terms are at most (2 * 2^(2 * 12))^2
/// each and sum to 2^51.
constexpr int kShortBits = 12;

}  // namespace

std::optional<Sign> incircleShort(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const IncircleEstimate estimate(a, b, c, d);
    const Vec2 largest = estimate.largestDifferences();
    const double difference = std::max(largest.x, largest.y);
    if (!areShort(flatCoordinates(a, b, c, d), difference, kShortBits)) return std::nullopt;
    return signOf(estimate.determinant);
}

std::optional<Sign> incircleInteger64(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const auto grid = toGrid64(flatCoordinates(a, b, c, d));
    if (!grid) return std::nullopt;
    return gridIncircle(*grid);
}

std::optional<Sign> incircleInteger128(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const auto grid = toGrid128(flatCoordinates(a, b, c, d));
    if (!grid) return std::nullopt;
    return gridIncircle(*grid);
}

Sign incircleExpansion(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    return expansionIncircle(a, b, c, d).sign();
}

Sign incircleExact(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    MESHER_PRECONDITION(isInExactRange(a) && isInExactRange(b) && isInExactRange(c) && isInExactRange(d));
    if (const auto sign = incircleShort(a, b, c, d)) return *sign;
    if (const auto sign = incircleInteger64(a, b, c, d)) return *sign;
    if (const auto sign = incircleInteger128(a, b, c, d)) return *sign;
    return incircleExpansion(a, b, c, d);
}

namespace {

/// The coefficient of the infinitesimal by which the lift of the point number `index` is raised.
Sign liftCoefficient(std::array<const Vec2*, 4> points, std::size_t index)
{
    constexpr std::size_t kLast = 3;
    const bool isLast = index == kLast;
    points[index] = points[kLast];
    const Sign orientation = orient2d(*points[0], *points[1], *points[2]);
    return isLast ? -orientation : orientation;
}

}  // namespace

Sign incirclePerturbation(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const std::array<const Vec2*, 4> points{&a, &b, &c, &d};
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::sort(order.begin(), order.end(), [&points](std::size_t i, std::size_t j) {
        return isLexicographicallyLess(*points[j], *points[i]);
    });
    // Coinciding points have the same lift, which makes two rows of the determinant equal.
    for (std::size_t i = 0; i + 1 < 4; ++i) {
        if (*points[order[i]] == *points[order[i + 1]]) return Sign::Zero;
    }
    for (const std::size_t index : order) {
        const Sign sign = liftCoefficient(points, index);
        if (sign != Sign::Zero) return sign;
    }
    return Sign::Zero;
}

}  // namespace mesher::detail
