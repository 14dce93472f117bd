#include "support/degenerate_points.h"

#include "support/temp_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

namespace mesher::test {
namespace {

constexpr std::size_t kCount = 300;

/// Exact: the generators checked with it make multiples of 2^-20 below 2^10, so that products of differences
/// fit into 64 bits.
std::int64_t fixedPoint(double coordinate)
{
    const double scaled = std::ldexp(coordinate, 20);
    EXPECT_EQ(scaled, std::nearbyint(scaled));
    return static_cast<std::int64_t>(scaled);
}

std::array<std::int64_t, 3> crossOfDifferences(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const std::int64_t ux = fixedPoint(b.x) - fixedPoint(a.x);
    const std::int64_t uy = fixedPoint(b.y) - fixedPoint(a.y);
    const std::int64_t uz = fixedPoint(b.z) - fixedPoint(a.z);
    const std::int64_t vx = fixedPoint(c.x) - fixedPoint(a.x);
    const std::int64_t vy = fixedPoint(c.y) - fixedPoint(a.y);
    const std::int64_t vz = fixedPoint(c.z) - fixedPoint(a.z);
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}

std::vector<Vec3> lifted(const std::vector<Vec2>& points)
{
    std::vector<Vec3> inSpace;
    for (const Vec2& point : points) inSpace.push_back({point.x, point.y, 0.0});
    return inSpace;
}

void expectCollinear(const std::vector<Vec3>& points)
{
    for (std::size_t i = 2; i < points.size(); ++i) {
        ASSERT_EQ(crossOfDifferences(points[0], points[1], points[i]), (std::array<std::int64_t, 3>{}));
    }
}

template <class Point>
std::size_t distinctCount(std::vector<Point> points)
{
    std::sort(points.begin(), points.end(),
              [](const Point& a, const Point& b) { return isLexicographicallyLess(a, b); });
    return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

template <class Point>
void expectReproducibleAndFinite(const std::vector<PointFamily<Point>>& families)
{
    std::set<std::string> names;
    for (const PointFamily<Point>& family : families) {
        SCOPED_TRACE(family.name);
        EXPECT_TRUE(names.insert(family.name).second);
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{7}, kCount}) {
            const std::vector<Point> points = family.make(count, 5);
            EXPECT_EQ(points.size(), count);
            EXPECT_TRUE(points == family.make(count, 5));
            EXPECT_TRUE(
                std::all_of(points.begin(), points.end(), [](const Point& p) { return isFinite(p); }));
        }
    }
}

TEST(DegeneratePoints, AreReproducibleAndFinite)
{
    expectReproducibleAndFinite(pointFamilies2d());
    expectReproducibleAndFinite(pointFamilies3d());
}

TEST(DegeneratePoints, FollowTheSeed)
{
    EXPECT_FALSE(uniformPoints2d(kCount, 1) == uniformPoints2d(kCount, 2));
    EXPECT_FALSE(uniformPoints3d(kCount, 1) == uniformPoints3d(kCount, 2));
    EXPECT_FALSE(torusPoints3d(kCount, 1) == torusPoints3d(kCount, 2));
}

TEST(DegeneratePoints, OnLinesAreExactlyCollinear)
{
    expectCollinear(lifted(collinearPoints2d(kCount, 3)));
    expectCollinear(collinearPoints3d(kCount, 3));
    EXPECT_EQ(distinctCount(collinearPoints2d(kCount, 3)), kCount);
    EXPECT_EQ(distinctCount(collinearPoints3d(kCount, 3)), kCount);
}

TEST(DegeneratePoints, OnAPlaneAreExactlyCoplanar)
{
    for (const Vec3& point : coplanarPoints3d(kCount, 3)) {
        ASSERT_EQ(fixedPoint(point.z), fixedPoint(point.x) + 2 * fixedPoint(point.y) - fixedPoint(1.0));
    }
}

TEST(DegeneratePoints, NearALineOrPlaneLeaveItByOnePoint)
{
    const std::vector<Vec2> onLine = collinearPoints2d(kCount, 3);
    const std::vector<Vec2> nearLine = nearlyCollinearPoints2d(kCount, 3);
    EXPECT_TRUE(std::equal(onLine.begin(), onLine.end() - 1, nearLine.begin()));
    EXPECT_GT(nearLine.back().y, onLine.back().y);
    const std::vector<Vec3> onPlane = coplanarPoints3d(kCount, 3);
    const std::vector<Vec3> nearPlane = nearlyCoplanarPoints3d(kCount, 3);
    EXPECT_TRUE(std::equal(onPlane.begin(), onPlane.end() - 1, nearPlane.begin()));
    EXPECT_GT(nearPlane.back().z, onPlane.back().z);
}

TEST(DegeneratePoints, OnCirclesAreExactlyCocircular)
{
    const std::vector<Vec2> points = cocircularPoints2d(kCount, 3);
    EXPECT_EQ(distinctCount(points), kCount);
    std::set<double> squaredRadii;
    for (const Vec2& point : points) squaredRadii.insert(squaredLength(point));
    EXPECT_EQ(squaredRadii.size(), (kCount + 63) / 64);
}

TEST(DegeneratePoints, OnSpheresAreExactlyCospherical)
{
    const std::vector<Vec3> points = cosphericalPoints3d(20 * kCount, 3);
    EXPECT_EQ(distinctCount(points), points.size());
    std::set<double> squaredRadii;
    for (const Vec3& point : points) {
        ASSERT_TRUE(point.x == std::nearbyint(point.x) && point.y == std::nearbyint(point.y));
        squaredRadii.insert(squaredLength(point));
    }
    EXPECT_LE(squaredRadii.size(), 20u);
}

TEST(DegeneratePoints, RepeatedHaveFewDistinctOnes)
{
    EXPECT_LE(distinctCount(duplicatedPoints2d(kCount, 3)), kCount / 10 + 1);
    EXPECT_LE(distinctCount(duplicatedPoints3d(kCount, 3)), kCount / 10 + 1);
    EXPECT_EQ(distinctCount(equalPoints3d(kCount)), 1u);
}

TEST(DegeneratePoints, WithinUlpsStayWithinTwoSteps)
{
    const double low = std::nextafter(std::nextafter(1.0, 0.0), 0.0);
    const double high = std::nextafter(std::nextafter(1.0, 2.0), 2.0);
    std::set<double> seen;
    for (const Vec3& point : ulpPoints3d(20 * kCount, 3)) {
        if (point.x < 1.5) seen.insert(point.x);
    }
    EXPECT_EQ(seen.size(), 5u);
    EXPECT_EQ(*seen.begin(), low);
    EXPECT_EQ(*seen.rbegin(), high);
}

TEST(DegeneratePoints, OnATorusLieOnIt)
{
    for (const Vec3& point : torusPoints3d(kCount, 3)) {
        const double fromAxis = std::hypot(point.x, point.y) - 1.0;
        ASSERT_NEAR(std::hypot(fromAxis, point.z), 0.4, 1e-14);
    }
}

TEST(Shuffle, IsAPermutationFixedByTheSeed)
{
    std::vector<int> items = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    Random random(17);
    shuffle(items, random);
    EXPECT_EQ(items, (std::vector<int>{7, 8, 6, 4, 9, 0, 1, 2, 3, 5}));
}

TEST(TempDir, IsEmptyAndRemovedWithItsContent)
{
    std::filesystem::path path;
    {
        const TempDir directory;
        const TempDir other;
        path = directory.path();
        EXPECT_NE(path, other.path());
        EXPECT_TRUE(std::filesystem::is_empty(path));
        std::ofstream(path / "file") << "content";
        EXPECT_FALSE(std::filesystem::is_empty(path));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace mesher::test
