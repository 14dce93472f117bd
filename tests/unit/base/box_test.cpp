#include "base/box.h"

#include <gtest/gtest.h>

#include <vector>

namespace mesher {
namespace {

TEST(Box, IsEmptyUntilItIncludesAPoint)
{
    Box3 box;
    EXPECT_TRUE(box.isEmpty());
    EXPECT_FALSE(box.contains({0, 0, 0}));
    box.include({1, 2, 3});
    EXPECT_FALSE(box.isEmpty());
    EXPECT_TRUE(box.contains({1, 2, 3}));
    EXPECT_EQ(box.extent(), (Vec3{0, 0, 0}));
    EXPECT_TRUE(Box2{}.isEmpty());
    EXPECT_TRUE(Box3::of({}).isEmpty());
}

TEST(Box, IsTheSmallestAroundItsPoints)
{
    const std::vector<Vec3> points = {{0, 5, -1}, {3, 1, 2}, {-2, 2, 0}};
    const Box3 box = Box3::of(points);
    EXPECT_EQ(box.low, (Vec3{-2, 1, -1}));
    EXPECT_EQ(box.high, (Vec3{3, 5, 2}));
    EXPECT_EQ(box.extent(), (Vec3{5, 4, 3}));
    const std::vector<Vec2> planar = {{0, 5}, {3, 1}, {-2, 2}};
    EXPECT_EQ(Box2::of(planar).low, (Vec2{-2, 1}));
    EXPECT_EQ(Box2::of(planar).high, (Vec2{3, 5}));
    EXPECT_EQ(Box2::of(planar).extent(), (Vec2{5, 4}));
}

TEST(Box, ContainsItsBoundaryAndNothingBeyond)
{
    const Box3 box{{0, 0, 0}, {1, 1, 1}};
    EXPECT_TRUE(box.contains({0, 0, 0}));
    EXPECT_TRUE(box.contains({1, 1, 1}));
    const Box2 square{{0, 0}, {1, 1}};
    EXPECT_TRUE(square.contains({0, 1}));
    for (const double outside : {-0.001, 1.001}) {
        EXPECT_FALSE(box.contains({outside, 0.5, 0.5}));
        EXPECT_FALSE(box.contains({0.5, outside, 0.5}));
        EXPECT_FALSE(box.contains({0.5, 0.5, outside}));
        EXPECT_FALSE(square.contains({outside, 0.5}));
        EXPECT_FALSE(square.contains({0.5, outside}));
    }
}

}  // namespace
}  // namespace mesher
