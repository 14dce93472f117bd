#include "base/vec.h"

#include <gtest/gtest.h>

#include <limits>

namespace mesher {
namespace {

TEST(Vec, ComputesWithComponents)
{
    EXPECT_EQ((Vec2{1, 2} + Vec2{10, 20}), (Vec2{11, 22}));
    EXPECT_EQ((Vec2{1, 2} - Vec2{10, 30}), (Vec2{-9, -28}));
    EXPECT_EQ((2.0 * Vec2{1, 2}), (Vec2{2, 4}));
    EXPECT_EQ((Vec3{1, 2, 3} + Vec3{10, 20, 30}), (Vec3{11, 22, 33}));
    EXPECT_EQ((Vec3{1, 2, 3} - Vec3{10, 30, 50}), (Vec3{-9, -28, -47}));
    EXPECT_EQ((2.0 * Vec3{1, 2, 3}), (Vec3{2, 4, 6}));
    EXPECT_EQ(dot(Vec2{1, 2}, Vec2{3, 5}), 13);
    EXPECT_EQ(dot(Vec3{1, 2, 3}, Vec3{3, 5, 7}), 34);
    EXPECT_EQ(length(Vec2{3, 4}), 5);
    EXPECT_EQ(length(Vec3{2, 3, 6}), 7);
}

TEST(Vec, CrossProductsAreRightHanded)
{
    EXPECT_EQ(cross(Vec2{1, 0}, Vec2{0, 1}), 1);
    EXPECT_EQ(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}), (Vec3{0, 0, 1}));
    EXPECT_EQ(cross(Vec3{0, 1, 0}, Vec3{0, 0, 1}), (Vec3{1, 0, 0}));
    EXPECT_EQ(cross(Vec3{0, 0, 1}, Vec3{1, 0, 0}), (Vec3{0, 1, 0}));
}

TEST(Vec, IsFiniteOnlyIfEachComponentIs)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(isFinite(Vec3{1, -2, 1e308}));
    EXPECT_TRUE(isFinite(Vec2{1, -2}));
    for (const double wrong : {infinity, -infinity, notANumber}) {
        EXPECT_FALSE(isFinite(Vec2{wrong, 0}));
        EXPECT_FALSE(isFinite(Vec2{0, wrong}));
        EXPECT_FALSE(isFinite(Vec3{wrong, 0, 0}));
        EXPECT_FALSE(isFinite(Vec3{0, wrong, 0}));
        EXPECT_FALSE(isFinite(Vec3{0, 0, wrong}));
    }
}

TEST(Vec, IsOrderedByXThenYThenZ)
{
    EXPECT_TRUE(isLexicographicallyLess(Vec2{1, 9}, Vec2{2, 0}));
    EXPECT_TRUE(isLexicographicallyLess(Vec2{1, 0}, Vec2{1, 9}));
    EXPECT_FALSE(isLexicographicallyLess(Vec2{1, 9}, Vec2{1, 9}));
    EXPECT_FALSE(isLexicographicallyLess(Vec2{2, 0}, Vec2{1, 9}));
    EXPECT_TRUE(isLexicographicallyLess(Vec3{1, 9, 9}, Vec3{2, 0, 0}));
    EXPECT_TRUE(isLexicographicallyLess(Vec3{1, 2, 9}, Vec3{1, 3, 0}));
    EXPECT_TRUE(isLexicographicallyLess(Vec3{1, 2, 3}, Vec3{1, 2, 4}));
    EXPECT_FALSE(isLexicographicallyLess(Vec3{1, 2, 3}, Vec3{1, 2, 3}));
    EXPECT_FALSE(isLexicographicallyLess(Vec3{1, 3, 0}, Vec3{1, 2, 9}));
}

}  // namespace
}  // namespace mesher
