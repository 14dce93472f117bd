#include "predicates/static_filter.h"

#include "predicates/incircle.h"
#include "predicates/insphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesher {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(StaticFilter, OfAnEmptyBoxDecidesNothing)
{
    EXPECT_EQ(StaticFilter2d::forBox(Box2{}).orient2d, kInfinity);
    EXPECT_EQ(StaticFilter2d::forBox(Box2{}).incircle, kInfinity);
    EXPECT_EQ(StaticFilter3d::forBox(Box3{}).orient3d, kInfinity);
    EXPECT_EQ(StaticFilter3d::forBox(Box3{}).insphere, kInfinity);
    EXPECT_EQ(StaticFilter3d{}.insphere, kInfinity);
}

TEST(StaticFilter, BoundsTheSemiStaticFilterOfPointsOfItsBox)
{
    // Differences along the whole box: the static bound must not be below the bound of the points themselves.
    const Vec3 low{0.1, -0.7, 2.3};
    const Vec3 high{0.9, 1.3, 77.7};
    const auto filter3 = StaticFilter3d::forBox({low, high});
    const Vec3 p{high.x, low.y, low.z}, q{low.x, high.y, low.z}, r{low.x, low.y, high.z};
    EXPECT_GE(filter3.orient3d, detail::Orient3dEstimate(low, p, q, r).errorBound());
    EXPECT_GE(filter3.insphere, detail::InsphereEstimate(low, p, q, r, high).errorBound());
    EXPECT_GT(filter3.insphere, 0.0);
    const auto filter2 = StaticFilter2d::forBox({{low.x, low.y}, {high.x, high.y}});
    const Vec2 a{low.x, low.y}, b{high.x, low.y}, c{low.x, high.y}, d{high.x, high.y};
    EXPECT_GE(filter2.orient2d, detail::Orient2dEstimate(a, b, c).errorBound());
    EXPECT_GE(filter2.incircle, detail::IncircleEstimate(a, b, c, d).errorBound());
}

TEST(StaticFilter, OfAFlatBoxLeavesZerosToTheOtherTiers)
{
    const auto filter = StaticFilter3d::forBox({{0, 0, 1}, {1, 1, 1}});
    EXPECT_EQ(filter.orient3d, 0.0);
    EXPECT_EQ(orient3d(filter, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}), Sign::Zero);
    EXPECT_EQ(inspherePerturbed(filter, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.3, 0.4, 1}),
              Sign::Zero);
}

TEST(StaticFilter, DoesNotChangeSignsOnItsBorder)
{
    const auto filter = StaticFilter3d::forBox({{0, 0, 0}, {1, 1, 1}});
    const double height = 0x1p-60;
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    EXPECT_EQ(orient3d(filter, a, b, c, {1, 1, height}), Sign::Positive);
    EXPECT_EQ(orient3d(filter, a, b, c, {1, 1, -height}), Sign::Negative);
    EXPECT_EQ(orient3d(filter, a, b, c, {1, 1, 0}), Sign::Zero);
}

}  // namespace
}  // namespace mesher
