#include "base/random.h"
#include "predicates/incircle.h"
#include "predicates/insphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "support/predicate_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace mesher {
namespace {

using test::kPointKindCount;
using test::makePointSets;
using test::PointKind;

constexpr std::uint64_t kSeed = 11;
constexpr std::uint64_t kSets = 2000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Sign orient(const std::vector<Vec2>& p) { return orient2d(p[0], p[1], p[2]); }
Sign orient(const std::vector<Vec3>& p) { return orient3d(p[0], p[1], p[2], p[3]); }
Sign sphere(const std::vector<Vec2>& p) { return incircle(p[0], p[1], p[2], p[3]); }
Sign sphere(const std::vector<Vec3>& p) { return insphere(p[0], p[1], p[2], p[3], p[4]); }

/// Calls the check with point sets of all families.
template <class Check>
void forAllSets(Check check)
{
    for (std::size_t kind = 0; kind < kPointKindCount; ++kind) {
        for (std::uint64_t i = 0; i < kSets; ++i) {
            SCOPED_TRACE(std::string(test::kPointKindNames[kind]) + " " + std::to_string(i));
            const auto sets = makePointSets(static_cast<PointKind>(kind), kSeed, i);
            check(sets.plane);
            check(sets.space);
        }
    }
}

TEST(PredicateLaws, OrientationOfTheUnitSimplexIsPositive)
{
    EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), Sign::Positive);
    EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Sign::Positive);
}

TEST(PredicateLaws, InsideIsPositiveForPositiveOrientation)
{
    const Vec2 a2{0, 0}, b2{1, 0}, c2{0, 1};
    EXPECT_EQ(incircle(a2, b2, c2, {0.9, 0.9}), Sign::Positive);
    EXPECT_EQ(incircle(a2, b2, c2, {1, 1}), Sign::Zero);
    EXPECT_EQ(incircle(a2, b2, c2, {1.1, 1}), Sign::Negative);
    EXPECT_EQ(incircle(b2, a2, c2, {0.9, 0.9}), Sign::Negative);
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
    EXPECT_EQ(insphere(a, b, c, d, {0.9, 0.9, 0.9}), Sign::Positive);
    EXPECT_EQ(insphere(a, b, c, d, {1, 1, 1}), Sign::Zero);
    EXPECT_EQ(insphere(a, b, c, d, {1.1, 1, 1}), Sign::Negative);
    EXPECT_EQ(insphere(b, a, c, d, {0.9, 0.9, 0.9}), Sign::Negative);
}

TEST(PredicateLaws, SwappingTwoPointsFlipsEachSign)
{
    forAllSets([](const auto& points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t j = i + 1; j < points.size(); ++j) {
                auto swapped = points;
                std::swap(swapped[i], swapped[j]);
                ASSERT_EQ(sphere(swapped), -sphere(points));
                if (j + 1 == points.size()) continue;
                ASSERT_EQ(orient(swapped), -orient(points));
            }
        }
    });
}

TEST(PredicateLaws, RotatingThreePointsKeepsTheOrientation)
{
    forAllSets([](const auto& points) {
        auto rotated = points;
        std::rotate(rotated.begin(), rotated.begin() + 1, rotated.begin() + 3);
        ASSERT_EQ(orient(rotated), orient(points));
        ASSERT_EQ(sphere(rotated), sphere(points));
    });
}

TEST(PredicateLaws, ScalingByAPowerOfTwoChangesNothing)
{
    for (const PointKind kind :
         {PointKind::Random, PointKind::Grid, PointKind::Cospherical, PointKind::Coplanar}) {
        for (std::uint64_t i = 0; i < kSets; ++i) {
            const auto sets = makePointSets(kind, kSeed, i);
            for (const double factor : {0x1p-30, 0x1p-7, 0x1p60}) {
                auto plane = sets.plane;
                auto space = sets.space;
                for (Vec2& p : plane) p = factor * p;
                for (Vec3& p : space) p = factor * p;
                ASSERT_EQ(orient(plane), orient(sets.plane));
                ASSERT_EQ(sphere(plane), sphere(sets.plane));
                ASSERT_EQ(orient(space), orient(sets.space));
                ASSERT_EQ(sphere(space), sphere(sets.space));
            }
        }
    }
}

TEST(PredicateLaws, ExactTranslationChangesNothing)
{
    Random random(kSeed);
    const auto coordinate = [&random](std::uint32_t size) { return double(random.below(size)); };
    for (int i = 0; i < 20000; ++i) {
        const std::uint32_t size = i % 2 == 0 ? 4 : 1u << 22;
        const Vec3 shift{coordinate(1u << 31) * 0x1p20, coordinate(1u << 31) * 0x1p20, -coordinate(1u << 31)};
        std::vector<Vec3> space(5);
        std::vector<Vec2> plane(4);
        for (Vec3& p : space) p = {coordinate(size), coordinate(size), coordinate(size)};
        for (Vec2& p : plane) p = {coordinate(size), coordinate(size)};
        auto movedSpace = space;
        auto movedPlane = plane;
        for (Vec3& p : movedSpace) p = p + shift;
        for (Vec2& p : movedPlane) p = p + Vec2{shift.x, shift.y};
        ASSERT_EQ(orient(movedSpace), orient(space));
        ASSERT_EQ(sphere(movedSpace), sphere(space));
        ASSERT_EQ(orient(movedPlane), orient(plane));
        ASSERT_EQ(sphere(movedPlane), sphere(plane));
    }
}

TEST(PredicateLaws, OneUlpOffAPlaneIsSeen)
{
    Random random(kSeed);
    const auto integer = [&random] { return double(random.below(2000)) - 1000.0; };
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a{integer(), integer(), integer()};
        const Vec3 u{integer(), integer(), integer()};
        const Vec3 v{integer(), integer(), integer()};
        const Vec3 b = a + u;
        const Vec3 c = a + v;
        const Vec3 d = a + integer() * u + integer() * v;
        ASSERT_EQ(orient3d(a, b, c, d), Sign::Zero);
        const Sign above = orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
        ASSERT_EQ(orient3d(a, b, c, {d.x, d.y, std::nextafter(d.z, kInfinity)}), above);
        ASSERT_EQ(orient3d(a, b, c, {d.x, d.y, std::nextafter(d.z, -kInfinity)}), -above);
    }
}

TEST(PredicateLaws, OneUlpOffALineIsSeen)
{
    Random random(kSeed);
    const auto integer = [&random] { return double(random.below(2000)) - 1000.0; };
    for (int i = 0; i < 20000; ++i) {
        const Vec2 a{integer(), integer()};
        const Vec2 u{1.0 + std::abs(integer()), integer()};
        const Vec2 c = a + integer() * u;
        ASSERT_EQ(orient2d(a, a + u, c), Sign::Zero);
        ASSERT_EQ(orient2d(a, a + u, {c.x, std::nextafter(c.y, kInfinity)}), Sign::Positive);
        ASSERT_EQ(orient2d(a, a + u, {c.x, std::nextafter(c.y, -kInfinity)}), Sign::Negative);
    }
}

TEST(PredicateLaws, OneUlpOffASphereIsSeen)
{
    // On |p|^2 = 9 and |p|^2 = 25; away from the origin is outside.
    const Vec3 a{3, 0, 0}, b{0, 3, 0}, c{-1, -2, 2}, d{0, 0, -3};
    const Sign orientation = orient3d(a, b, c, d);
    ASSERT_NE(orientation, Sign::Zero);
    for (const Vec3 e : {Vec3{1, 2, 2}, Vec3{-2, 1, 2}, Vec3{2, -2, 1}, Vec3{2, 1, -2}}) {
        EXPECT_EQ(insphere(a, b, c, d, e), Sign::Zero);
        EXPECT_EQ(insphere(a, b, c, d, {std::nextafter(e.x, 0.0), e.y, e.z}), orientation);
        EXPECT_EQ(insphere(a, b, c, d, {std::nextafter(e.x, 9.0 * e.x), e.y, e.z}), -orientation);
    }
    const Vec2 a2{5, 0}, b2{3, 4}, c2{-4, 3};
    for (const Vec2 e : {Vec2{-3, -4}, Vec2{4, -3}, Vec2{3, -4}}) {
        EXPECT_EQ(incircle(a2, b2, c2, e), Sign::Zero);
        EXPECT_EQ(incircle(a2, b2, c2, {e.x, std::nextafter(e.y, 0.0)}), Sign::Positive);
        EXPECT_EQ(incircle(a2, b2, c2, {e.x, std::nextafter(e.y, 9.0 * e.y)}), Sign::Negative);
    }
}

TEST(PredicateLaws, CoincidingPointsAreDegenerate)
{
    forAllSets([](auto points) {
        points[1] = points[0];
        ASSERT_EQ(orient(points), Sign::Zero);
        ASSERT_EQ(sphere(points), Sign::Zero);
    });
}

}  // namespace
}  // namespace mesher
