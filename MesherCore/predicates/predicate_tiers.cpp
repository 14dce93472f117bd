#include "predicates/predicate_tiers.h"

#include "predicates/exact_tiers.h"
#include "predicates/incircle.h"
#include "predicates/insphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"

#include <array>
#include <cmath>
#include <optional>

namespace mesher {

namespace {

template <class Estimate>
std::optional<Decision> decideByFilters(const Estimate& estimate, double staticBound)
{
    const double magnitude = std::abs(estimate.determinant);
    if (magnitude > staticBound) return Decision{signOfNonZero(estimate.determinant), Tier::StaticFilter};
    const double bound = estimate.errorBound();
    if (magnitude > bound) return Decision{signOfNonZero(estimate.determinant), Tier::SemiStaticFilter};
    if (bound == 0.0) return Decision{Sign::Zero, Tier::Flat};
    return std::nullopt;
}

template <class Short, class Integer64, class Integer128, class Expansion, class... Points>
Decision decideExactly(Short byShort, Integer64 byInteger64, Integer128 byInteger128, Expansion byExpansion,
                       const Points&... points)
{
    if (const auto sign = byShort(points...)) return {*sign, Tier::Short};
    if (const auto sign = byInteger64(points...)) return {*sign, Tier::Integer64};
    if (const auto sign = byInteger128(points...)) return {*sign, Tier::Integer128};
    return {byExpansion(points...), Tier::Expansion};
}

}  // namespace

const char* nameOf(Tier tier)
{
    constexpr std::array<const char*, kTierCount> names{
        "static filter", "semi-static filter", "flat", "short", "integer 64", "integer 128", "expansion"};
    return names[static_cast<std::size_t>(tier)];
}

Decision decideOrient2d(const StaticFilter2d& filter, const Vec2& a, const Vec2& b, const Vec2& c)
{
    using namespace detail;
    if (const auto decision = decideByFilters(Orient2dEstimate(a, b, c), filter.orient2d)) return *decision;
    return decideExactly(orient2dShort, orient2dInteger64, orient2dInteger128, orient2dExpansion, a, b, c);
}

Decision decideIncircle(const StaticFilter2d& filter, const Vec2& a, const Vec2& b, const Vec2& c,
                        const Vec2& d)
{
    using namespace detail;
    if (const auto decision = decideByFilters(IncircleEstimate(a, b, c, d), filter.incircle))
        return *decision;
    return decideExactly(incircleShort, incircleInteger64, incircleInteger128, incircleExpansion, a, b, c, d);
}

Decision decideOrient3d(const StaticFilter3d& filter, const Vec3& a, const Vec3& b, const Vec3& c,
                        const Vec3& d)
{
    using namespace detail;
    if (const auto decision = decideByFilters(Orient3dEstimate(a, b, c, d), filter.orient3d))
        return *decision;
    return decideExactly(orient3dShort, orient3dInteger64, orient3dInteger128, orient3dExpansion, a, b, c, d);
}

Decision decideInsphere(const StaticFilter3d& filter, const Vec3& a, const Vec3& b, const Vec3& c,
                        const Vec3& d, const Vec3& e)
{
    using namespace detail;
    if (const auto decision = decideByFilters(InsphereEstimate(a, b, c, d, e), filter.insphere))
        return *decision;
    return decideExactly(insphereShort, insphereInteger64, insphereInteger128, insphereExpansion, a, b, c, d,
                         e);
}

}  // namespace mesher
