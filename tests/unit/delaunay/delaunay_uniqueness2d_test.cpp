#include "base/random.h"
#include "support/degenerate_points.h"
#include "unit/delaunay/delaunay2d_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mesher::test {
namespace {

class DelaunayUniqueness2d : public testing::TestWithParam<PointFamily<Vec2>>
{
};

TEST_P(DelaunayUniqueness2d, IsSoundForAnyNumberOfPoints)
{
    for (const std::size_t count : {0u, 1u, 2u, 3u, 4u, 5u, 17u, 120u, 5000u}) {
        const auto points = GetParam().make(count, 1);
        EXPECT_TRUE(isSound(insertedInBulk(points))) << count;
    }
}

TEST_P(DelaunayUniqueness2d, DoesNotDependOnTheOrderOfInsertion)
{
    Random random(2);
    std::vector<Vec2> points = GetParam().make(500, 3);
    const std::uint64_t expected = hashOf(insertedInBulk(points));
    for (int round = 0; round < 5; ++round) {
        shuffle(points, random);
        EXPECT_EQ(hashOf(insertedInBulk(points, 10 + static_cast<std::uint64_t>(round))), expected);
        EXPECT_EQ(hashOf(insertedOneByOne(points)), expected);
    }
    std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return isLexicographicallyLess(a, b); });
    EXPECT_EQ(hashOf(insertedOneByOne(points)), expected);
}

TEST_P(DelaunayUniqueness2d, DoesNotDependOnHowTheBulkIsSplit)
{
    const std::vector<Vec2> points = GetParam().make(3000, 4);
    const std::span<const Vec2> all(points);
    Delaunay2d delaunay;
    for (const std::size_t begin : {0u, 1000u, 2000u}) {
        ASSERT_TRUE(delaunay.insertPoints(all.subspan(begin, 1000)).hasValue());
    }
    EXPECT_EQ(hashOf(delaunay), hashOf(insertedInBulk(points)));
    EXPECT_TRUE(isSound(delaunay));
    EXPECT_EQ(delaunay.counters().starRepairs, 0u);
}

TEST_P(DelaunayUniqueness2d, KeepsItsTrianglesWhenScaledByAPowerOfTwo)
{
    std::vector<Vec2> points = GetParam().make(300, 5);
    const Delaunay2d plain = insertedOneByOne(points);
    for (Vec2& p : points) p = 0x1p-30 * p;
    const Delaunay2d scaled = insertedOneByOne(points);
    EXPECT_EQ(edgesOf(plain.mesh()), edgesOf(scaled.mesh()));
}

INSTANTIATE_TEST_SUITE_P(Families, DelaunayUniqueness2d, testing::ValuesIn(pointFamilies2d()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace mesher::test
