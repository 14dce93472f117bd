#include "predicates/orient2d.h"

#include "base/assert.h"
#include "predicates/coordinate_range.h"
#include "predicates/exact_tiers.h"
#include "predicates/expansion_determinants.h"
#include "predicates/integer_determinants.h"

#include <array>

namespace mesher::detail {

std::optional<Sign> orient2dInteger64(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const auto grid = toGrid64(std::array<double, 6>{a.x, a.y, b.x, b.y, c.x, c.y});
    if (!grid) return std::nullopt;
    return gridOrient2d(*grid);
}

std::optional<Sign> orient2dInteger128(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const auto grid = toGrid128(std::array<double, 6>{a.x, a.y, b.x, b.y, c.x, c.y});
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
    if (const auto sign = orient2dInteger64(a, b, c)) return *sign;
    if (const auto sign = orient2dInteger128(a, b, c)) return *sign;
    return orient2dExpansion(a, b, c);
}

}  // namespace mesher::detail
