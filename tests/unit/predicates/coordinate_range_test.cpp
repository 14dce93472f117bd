#include "predicates/coordinate_range.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace mesher {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool isIn(double x) { return isInExactRange(Vec2{0.0, x}) && isInExactRange(Vec3{1.0, x, 0.0}); }

TEST(ExactRange, EndsWhereItSays)
{
    EXPECT_TRUE(isIn(0.0));
    EXPECT_TRUE(isIn(-0.1));
    EXPECT_TRUE(isIn(0x1p200));
    EXPECT_TRUE(isIn(-0x1p200));
    EXPECT_FALSE(isIn(std::nextafter(0x1p200, kInfinity)));
    EXPECT_TRUE(isIn(0x1p-200));
    EXPECT_FALSE(isIn(0x1p-201));
    EXPECT_FALSE(isIn(-0x1.8p-200));
    EXPECT_TRUE(isIn(0x1.8p-199));
    // 2^-148 is the first power of two of which all neighbours above are on the grid.
    EXPECT_TRUE(isIn(std::nextafter(0x1p-148, 1.0)));
    EXPECT_FALSE(isIn(std::nextafter(0x1p-148, 0.0)));
    EXPECT_FALSE(isIn(5e-324));
}

TEST(ExactRange, RefusesWhatIsNotFinite)
{
    for (const double bad : {kInfinity, -kInfinity, kNaN}) {
        EXPECT_FALSE(isInExactRange(Vec2{bad, 0.0}));
        EXPECT_FALSE(isInExactRange(Vec2{0.0, bad}));
        EXPECT_FALSE(isInExactRange(Vec3{bad, 0.0, 0.0}));
        EXPECT_FALSE(isInExactRange(Vec3{0.0, bad, 0.0}));
        EXPECT_FALSE(isInExactRange(Vec3{0.0, 0.0, bad}));
    }
}

TEST(PowerOfTwoScaling, IsExactBothWaysForModelsOfAnySize)
{
    Random random(4);
    for (const double size : {1e-300, 1e-12, 1.0, 1e3, 1e300}) {
        std::vector<Vec3> points;
        for (int i = 0; i < 1000; ++i) {
            points.push_back(
                {size * random.between(-1, 1), size * random.between(-1, 1), size * random.unit()});
        }
        const auto scaling = PowerOfTwoScaling::forPoints(points);
        ASSERT_TRUE(scaling);
        double largest = 0.0;
        for (const Vec3& p : points) {
            std::size_t rounded = 0;
            const Vec3 q = scaling->toKernel(p, rounded);
            EXPECT_EQ(rounded, 0u);
            EXPECT_TRUE(isInExactRange(q));
            EXPECT_EQ(scaling->toModel(q), p);
            largest = std::max({largest, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
        }
        EXPECT_GE(largest, 0x1p99);
        EXPECT_LT(largest, 0x1p100);
    }
}

TEST(PowerOfTwoScaling, RoundsAndCountsWhatIsTooFine)
{
    const auto scaling = PowerOfTwoScaling::forBox(Box2{{-1.0, -1.0}, {1.0, 1.0}});
    ASSERT_TRUE(scaling);
    ASSERT_EQ(scaling->exponent(), 99);
    std::size_t rounded = 0;
    EXPECT_EQ(scaling->toKernel(Vec2{0x1p-299, 0x1p-298}, rounded), (Vec2{0x1p-200, 0x1p-199}));
    EXPECT_EQ(rounded, 0u);
    EXPECT_EQ(scaling->toKernel(Vec2{0x1.cp-299, 0x1p-301}, rounded), (Vec2{0x1p-199, 0.0}));
    EXPECT_EQ(rounded, 2u);
    EXPECT_EQ(scaling->toKernel(Vec3{0.5, -5e-324, 0.0}, rounded), (Vec3{0x1p98, 0.0, 0.0}));
    EXPECT_EQ(rounded, 3u);
}

TEST(PowerOfTwoScaling, CountsWhatScalingItselfUnderflows)
{
    const auto scaling = PowerOfTwoScaling::forBox(Box3{{0, 0, 0}, {1e300, 0, 0}});
    ASSERT_TRUE(scaling);
    std::size_t rounded = 0;
    EXPECT_EQ(scaling->toKernel(Vec3{1e300, 1e-300, 0.0}, rounded).y, 0.0);
    EXPECT_EQ(rounded, 1u);
}

TEST(PowerOfTwoScaling, GivesPlusZeroForMinusZero)
{
    const auto scaling = PowerOfTwoScaling::forBox(Box2{{0, 0}, {1, 1}});
    ASSERT_TRUE(scaling);
    std::size_t rounded = 0;
    EXPECT_FALSE(std::signbit(scaling->toKernel(Vec2{-0.0, -1e-300}, rounded).x));
    EXPECT_FALSE(std::signbit(scaling->toKernel(Vec2{-0.0, -1e-300}, rounded).y));
}

TEST(PowerOfTwoScaling, LeavesEmptyAndZeroModelsAlone)
{
    EXPECT_EQ(PowerOfTwoScaling::forBox(Box3{}).value().exponent(), 0);
    EXPECT_EQ(PowerOfTwoScaling::forBox(Box2{}).value().exponent(), 0);
    EXPECT_EQ(PowerOfTwoScaling::forBox(Box3{{0, 0, 0}, {0, 0, 0}}).value().exponent(), 0);
    EXPECT_EQ(PowerOfTwoScaling::forPoints(std::vector<Vec2>{}).value().exponent(), 0);
}

TEST(PowerOfTwoScaling, RefusesNonFinitePointsByNumber)
{
    for (const double bad : {kInfinity, -kInfinity, kNaN}) {
        const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 3}, {0, 0, bad}};
        const auto refused = PowerOfTwoScaling::forPoints(points);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::NonFinitePoint);
        EXPECT_EQ(refused.error().entity, "point 2");
        EXPECT_FALSE(PowerOfTwoScaling::forPoints(std::vector<Vec2>{{bad, 0}}));
        EXPECT_FALSE(PowerOfTwoScaling::forBox(Box2{{0, bad}, {1, 1}}));
        EXPECT_FALSE(PowerOfTwoScaling::forBox(Box3{{0, 0, 0}, {1, bad, 1}}));
    }
}

}  // namespace
}  // namespace mesher
