#include "predicates/circumcenter.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesher {
namespace {

TEST(Circumcenter, OfRightSimplicesIsExact)
{
    EXPECT_EQ(approximateCircumcenter(Vec2{1, 1}, Vec2{3, 1}, Vec2{1, 5}), (Vec2{2, 3}));
    EXPECT_EQ(approximateCircumcenter(Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 0, 4}), (Vec3{1, 0, 2}));
    EXPECT_EQ(approximateCircumcenter(Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 4, 0}, Vec3{0, 0, 6}),
              (Vec3{1, 2, 3}));
}

TEST(Circumcenter, OfFlatElementsIsNothing)
{
    EXPECT_FALSE(approximateCircumcenter(Vec2{0, 0}, Vec2{1, 1}, Vec2{2, 2}));
    EXPECT_FALSE(approximateCircumcenter(Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{2, 2, 2}));
    EXPECT_FALSE(approximateCircumcenter(Vec3{0, 0, 0}, Vec3{1, 0, 1}, Vec3{0, 1, 1}, Vec3{1, 1, 2}));
}

TEST(Circumcenter, IsEquidistantFarFromTheOrigin)
{
    Random random(12);
    int checked = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 far{random.between(900, 1000), random.between(900, 1000), random.between(900, 1000)};
        const auto point = [&] {
            return far + 0.01 * Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        };
        const Vec3 a = point(), b = point(), c = point(), d = point();
        const auto centre = approximateCircumcenter(a, b, c, d);
        ASSERT_TRUE(centre);
        const double radius = length(*centre - a);
        if (radius > 0.02) continue;  // a sliver: its centre is ill-conditioned
        ++checked;
        for (const Vec3& p : {b, c, d}) ASSERT_NEAR(length(*centre - p), radius, 1e-11);
        const auto inPlane = approximateCircumcenter(a, b, c);
        ASSERT_TRUE(inPlane);
        const double planeRadius = length(*inPlane - a);
        ASSERT_NEAR(length(*inPlane - b), planeRadius, 1e-11);
        ASSERT_NEAR(length(*inPlane - c), planeRadius, 1e-11);
        const Vec3 normal = cross(b - a, c - a);
        ASSERT_NEAR(dot(normal, *inPlane - a), 0.0, 1e-11 * length(normal));
    }
    EXPECT_GT(checked, 1000);
}

TEST(Circumcenter, OfPlaneTrianglesIsEquidistant)
{
    Random random(13);
    for (int i = 0; i < 5000; ++i) {
        const auto point = [&] { return Vec2{1000 + random.unit(), -500 + random.unit()}; };
        const Vec2 a = point(), b = point(), c = point();
        const auto centre = approximateCircumcenter(a, b, c);
        ASSERT_TRUE(centre);
        const double radius = length(*centre - a);
        if (radius > 2.0) continue;
        ASSERT_NEAR(length(*centre - b), radius, 1e-10);
        ASSERT_NEAR(length(*centre - c), radius, 1e-10);
    }
}

}  // namespace
}  // namespace mesher
