#pragma once

#include "base/vec.h"
#include "predicates/sign.h"
#include "predicates/static_filter.h"

#include <cstddef>

/// Which tier decides a predicate, for tests and fuzzers: the production functions do not know of this
/// header. The single exact tiers are in exact_tiers.h.
namespace mesher {

/// In the order in which they are tried.
enum class Tier
{
    StaticFilter,
    SemiStaticFilter,
    Flat,  ///< all points agree in one coordinate: the determinant vanishes
    Short,
    Integer64,
    Integer128,
    Expansion
};
inline constexpr std::size_t kTierCount = 7;

[[nodiscard]] const char* nameOf(Tier tier);

struct Decision
{
    Sign sign;
    Tier tier;

    friend constexpr bool operator==(const Decision&, const Decision&) = default;
};

[[nodiscard]] Decision decideOrient2d(const StaticFilter2d& filter, const Vec2& a, const Vec2& b,
                                      const Vec2& c);
[[nodiscard]] Decision decideIncircle(const StaticFilter2d& filter, const Vec2& a, const Vec2& b,
                                      const Vec2& c, const Vec2& d);
[[nodiscard]] Decision decideOrient3d(const StaticFilter3d& filter, const Vec3& a, const Vec3& b,
                                      const Vec3& c, const Vec3& d);
[[nodiscard]] Decision decideInsphere(const StaticFilter3d& filter, const Vec3& a, const Vec3& b,
                                      const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace mesher
