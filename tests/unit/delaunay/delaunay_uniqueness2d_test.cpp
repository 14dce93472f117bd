#include "base/random.h"
#include "support/degenerate_points.h"
#include "unit/delaunay/delaunay2d_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

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

/// The same on every platform and in every build type. The families that call the mathematical library, whose rounding
/// differs, are not among them.
TEST(MeshHash2d, IsTheSameEverywhere)
{
    const std::pair<const char*, std::uint64_t> expected[] = {
        {"uniform", 0x9091B890AFFF2F4Bu},
        {"grid", 0x6B8C4312A8BB7701u},
        {"cocircular", 0x9BC9E428A975BB3Du},
        {"collinear", 0x1128BC04AFAB45ECu},
        {"nearly_collinear", 0x9DACF21D6DA333B9u},
        {"duplicated", 0xC16B34742ABE54CFu},
        {"ulp", 0xC7EBF3C72A72C771u},
        {"huge", 0x28288048785776F8u},
        {"tiny", 0xDF2704B7A73488FCu},
        {"far_offset_grid", 0x186E20F3698F18DEu},
        {"equal", 0xD2A8BC277637796Cu},
    };
    for (const auto& [name, hash] : expected) {
        for (const PointFamily<Vec2>& family : pointFamilies2d()) {
            if (family.name != name) continue;
            EXPECT_EQ(hashOf(insertedInBulk(family.make(2000, 42))), hash) << name;
            EXPECT_EQ(hashOf(insertedOneByOne(family.make(2000, 42))), hash) << name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, DelaunayUniqueness2d, testing::ValuesIn(pointFamilies2d()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace mesher::test
