#include "delaunay/spatial_order.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace mesher {
namespace {

template <class Point>
std::vector<Point> randomPoints(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Point> points(count);
    for (Point& p : points) {
        p.x = random.between(-3.0, 5.0);
        p.y = random.between(0.0, 2.0);
        if constexpr (std::is_same_v<Point, Vec3>) p.z = random.between(1e3, 1.001e3);
    }
    return points;
}

bool isPermutation(std::vector<std::uint32_t> order, std::size_t count)
{
    std::vector<std::uint32_t> identity(count);
    std::iota(identity.begin(), identity.end(), 0u);
    std::sort(order.begin(), order.end());
    return order == identity;
}

template <class Point>
double pathLength(const std::vector<Point>& points, const std::vector<std::uint32_t>& order)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < order.size(); ++i) sum += length(points[order[i]] - points[order[i - 1]]);
    return sum;
}

template <class Point>
class SpatialOrder : public testing::Test
{
};
using PointTypes = testing::Types<Vec2, Vec3>;
TYPED_TEST_SUITE(SpatialOrder, PointTypes);

TYPED_TEST(SpatialOrder, IsAPermutationOfAnyNumberOfPoints)
{
    for (const std::size_t count : {0u, 1u, 2u, 3u, 999u, 8001u, 70000u}) {
        const auto points = randomPoints<TypeParam>(count, 7);
        EXPECT_TRUE(isPermutation(hilbertOrder(std::span<const TypeParam>(points)), count)) << count;
        EXPECT_TRUE(isPermutation(brioOrder(std::span<const TypeParam>(points), 1), count)) << count;
    }
}

TYPED_TEST(SpatialOrder, KeepsTheInputOrderOfEqualPoints)
{
    const std::vector<TypeParam> points(5000, TypeParam{1.5, -2.0});
    const auto order = hilbertOrder(std::span<const TypeParam>(points));
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
    EXPECT_EQ(order.size(), points.size());
}

TYPED_TEST(SpatialOrder, IsAFunctionOfPointsAndSeed)
{
    const auto points = randomPoints<TypeParam>(20000, 3);
    const std::span<const TypeParam> span(points);
    EXPECT_EQ(brioOrder(span, 5), brioOrder(span, 5));
    EXPECT_NE(brioOrder(span, 5), brioOrder(span, 6));
    EXPECT_NE(brioOrder(span, 5), hilbertOrder(span));
}

TYPED_TEST(SpatialOrder, IsLocal)
{
    const auto points = randomPoints<TypeParam>(20000, 11);
    std::vector<std::uint32_t> identity(points.size());
    std::iota(identity.begin(), identity.end(), 0u);
    const double random = pathLength(points, identity);
    EXPECT_LT(pathLength(points, hilbertOrder(std::span<const TypeParam>(points))), 0.05 * random);
    EXPECT_LT(pathLength(points, brioOrder(std::span<const TypeParam>(points), 2)), 0.08 * random);
}

TYPED_TEST(SpatialOrder, SeparatesTightClustersFarBelowTheCoarseCells)
{
    // Two clusters a box diagonal apart, each 2^-14 wide: hundreds of points per cell of the coarse sort.
    auto points = randomPoints<TypeParam>(4000, 13);
    for (TypeParam& p : points) p = 0x1p-14 * p;
    points.push_back(TypeParam{1e3, 1e3});
    std::vector<std::uint32_t> identity(points.size());
    std::iota(identity.begin(), identity.end(), 0u);
    const double random = pathLength(points, identity);
    EXPECT_LT(pathLength(points, hilbertOrder(std::span<const TypeParam>(points))) - 1.5e3,
              0.4 * (random - 1.4e3));
}

TYPED_TEST(SpatialOrder, ToleratesExtremeCoordinates)
{
    constexpr double kMax = std::numeric_limits<double>::max();
    const std::vector<TypeParam> points{{-kMax, 0.0}, {kMax, 1.0}, {5e-324, 0.0}, {0.0, kMax}};
    EXPECT_TRUE(isPermutation(hilbertOrder(std::span<const TypeParam>(points)), points.size()));
    const std::vector<TypeParam> tiny{{0.0, 0.0}, {5e-324, 0.0}, {1e-323, 5e-324}};
    EXPECT_TRUE(isPermutation(hilbertOrder(std::span<const TypeParam>(tiny)), tiny.size()));
}

TEST(HilbertOrder, VisitsTheCellsOfASquareGridSideBySide)
{
    std::vector<Vec2> points;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) points.push_back({(x + 0.5) / 64.0, (y + 0.5) / 64.0});
    }
    points.push_back({0.0, 0.0});  // the corners fix the bounding square to the grid
    points.push_back({1.0, 1.0});
    auto order = hilbertOrder(points);
    std::erase_if(order, [](std::uint32_t i) { return i >= 64u * 64u; });
    for (std::size_t i = 1; i < order.size(); ++i) {
        EXPECT_DOUBLE_EQ(length(points[order[i]] - points[order[i - 1]]), 1.0 / 64.0) << i;
    }
}

TEST(HilbertOrder, VisitsTheCellsOfACubeGridSideBySide)
{
    std::vector<Vec3> points;
    for (int z = 0; z < 16; ++z) {
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x)
                points.push_back({(x + 0.5) / 16.0, (y + 0.5) / 16.0, (z + 0.5) / 16.0});
        }
    }
    points.push_back({0.0, 0.0, 0.0});
    points.push_back({1.0, 1.0, 1.0});
    auto order = hilbertOrder(points);
    std::erase_if(order, [](std::uint32_t i) { return i >= 16u * 16u * 16u; });
    for (std::size_t i = 1; i < order.size(); ++i) {
        EXPECT_DOUBLE_EQ(length(points[order[i]] - points[order[i - 1]]), 1.0 / 16.0) << i;
    }
}

TEST(BrioOrder, BeginsWithASampleOfTheWholeCloud)
{
    const auto points = randomPoints<Vec2>(100000, 17);
    const auto order = brioOrder(points, 4);
    Vec2 low{1e9, 1e9};
    Vec2 high{-1e9, -1e9};
    for (std::size_t i = 0; i < 2000; ++i) {
        const Vec2 p = points[order[i]];
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    EXPECT_GT(high.x - low.x, 7.5);
    EXPECT_GT(high.y - low.y, 1.8);
}

}  // namespace
}  // namespace mesher
