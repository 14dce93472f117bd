#include "quality/triangle_measures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesher {
namespace {

TEST(TriangleShape, OfTheEquilateralTriangleIsTheBest)
{
    const TriangleShape shape = shapeOf({{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}});
    EXPECT_NEAR(shape.minAngle, 60.0, 1e-12);
    EXPECT_NEAR(shape.maxAngle, 60.0, 1e-12);
    EXPECT_NEAR(shape.radiusRatio, 1.0, 1e-14);
    EXPECT_NEAR(shape.area, std::sqrt(3.0) / 2.0, 1e-15);
    EXPECT_NEAR(shape.shortestEdge, std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(shape.longestEdge, std::sqrt(2.0), 1e-15);
}

TEST(TriangleShape, OfARightTriangleHasItsAnglesAtItsCorners)
{
    // Sides 3, 4, 5: r = 1, R = 2.5.
    const TriangleShape shape = shapeOf({{{0.0, 0.0, 7.0}, {4.0, 0.0, 7.0}, {0.0, 3.0, 7.0}}});
    EXPECT_NEAR(shape.angle[0], 90.0, 1e-12);
    EXPECT_NEAR(shape.angle[1], 36.86989764584402, 1e-12);
    EXPECT_NEAR(shape.angle[2], 53.13010235415598, 1e-12);
    EXPECT_NEAR(shape.radiusRatio, 0.8, 1e-15);
    EXPECT_DOUBLE_EQ(shape.area, 6.0);
    EXPECT_DOUBLE_EQ(shape.shortestEdge, 3.0);
    EXPECT_DOUBLE_EQ(shape.longestEdge, 5.0);
}

TEST(TriangleShape, OfAFlatTriangleIsTheWorst)
{
    const TriangleShape shape = shapeOf({{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}}});
    EXPECT_EQ(shape.minAngle, 0.0);
    EXPECT_NEAR(shape.maxAngle, 180.0, 1e-12);
    EXPECT_EQ(shape.radiusRatio, 0.0);
    EXPECT_EQ(shapeOf({}).radiusRatio, 0.0);
}

TEST(DoubleAreaVector, LooksToWhereTheCornersAreSeenCounterclockwise)
{
    EXPECT_EQ(doubleAreaVector({{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}}}), (Vec3{0.0, 0.0, 4.0}));
}

}  // namespace
}  // namespace mesher
