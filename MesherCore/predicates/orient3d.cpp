#include "predicates/orient3d.h"

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

/// Bits of the differences for which all sums stay below 2^53: six terms of at most 2^(3 * 16) each.
constexpr int kShortBits = 16;

}  // namespace

std::optional<Sign> orient3dShort(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Orient3dEstimate estimate(a, b, c, d);
    const Vec3 largest = estimate.largestDifferences();
    const double difference = std::max(std::max(largest.x, largest.y), largest.z);
    if (!areShort(flatCoordinates(a, b, c, d), difference, kShortBits)) return std::nullopt;
    return signOf(estimate.determinant);
}

std::optional<Sign> orient3dInteger64(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const auto grid = toGrid64(flatCoordinates(a, b, c, d));
    if (!grid) return std::nullopt;
    return gridOrient3d(*grid);
}

std::optional<Sign> orient3dInteger128(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const auto grid = toGrid128(flatCoordinates(a, b, c, d));
    if (!grid) return std::nullopt;
    return gridOrient3d(*grid);
}

Sign orient3dExpansion(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return expansionOrient3d(a, b, c, d).sign();
}

Sign orient3dExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    MESHER_PRECONDITION(isInExactRange(a) && isInExactRange(b) && isInExactRange(c) && isInExactRange(d));
    if (const auto sign = orient3dShort(a, b, c, d)) return *sign;
    if (const auto sign = orient3dInteger64(a, b, c, d)) return *sign;
    if (const auto sign = orient3dInteger128(a, b, c, d)) return *sign;
    return orient3dExpansion(a, b, c, d);
}

}  // namespace mesher::detail
