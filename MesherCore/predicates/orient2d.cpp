#include "predicates/orient2d.h"

#include "base/assert.h"
#include "predicates/coordinate_range.h"
#include "predicates/exact_tiers.h"
#include "predicates/expansion_determinants.h"
#include "predicates/flat_coordinates.h"
#include "predicates/integer_determinants.h"
#include "predicates/short_coordinates.h"

#include <algorithm>

namespace mesher::detail {

namespace {

/// Bits of the differences for which all sums stay below 2^53: |u x v| <= 2 * 2^(2 * 25).
constexpr int kShortBits = 25;

}  // namespace

std::optional<Sign> orient2dShort(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const Orient2dEstimate estimate(a, b, c);
    const Vec2 largest = estimate.largestDifferences();
    const double difference = std::max(largest.x, largest.y);
    if (!areShort(flatCoordinates(a, b, c), difference, kShortBits)) return std::nullopt;
    return signOf(estimate.determinant);
}

std::optional<Sign> orient2dInteger64(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const auto grid = toGrid64(flatCoordinates(a, b, c));
    if (!grid) return std::nullopt;
    return gridOrient2d(*grid);
}

std::optional<Sign> orient2dInteger128(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const auto grid = toGrid128(flatCoordinates(a, b, c));
    if (!grid) return std::nullopt;
    return gridOrient2d(*grid);
}

Sign orient2dExpansion(const Vec2& a, const Vec2& b, const Vec2& c)
{
    return expansionOrient2d(a, b, c).sign();
}

Sign orient2dExact(const Vec2& a, const Vec2& b, const Vec2& c)
{
    MESHER_PRECONDITION(isInExactRange(a) && isInExactRange(b) && isInExactRange(c));
    if (const auto sign = orient2dShort(a, b, c)) return *sign;
    if (const auto sign = orient2dInteger64(a, b, c)) return *sign;
    if (const auto sign = orient2dInteger128(a, b, c)) return *sign;
    return orient2dExpansion(a, b, c);
}

}  // namespace mesher::detail
