#include "delaunay/segment_recovery2d.h"

#include "base/random.h"
#include "support/degenerate_points.h"
#include "unit/delaunay/delaunay2d_test_support.h"

#include <gtest/gtest.h>

namespace mesher::test {
namespace {

TEST(SegmentRecovery2d, ConstrainsAnEdgeThatIsThere)
{
    Delaunay2d delaunay = insertedOneByOne({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}});
    const auto result = delaunay.recoverSegment(VertexId(0), VertexId(1));
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->recoveryFlips + result->delaunayFlips, 0u);
    EXPECT_TRUE(delaunay.mesh().isConstrained(delaunay.mesh().findEdge(VertexId(1), VertexId(0))));
    EXPECT_TRUE(isSound(delaunay));
}

TEST(SegmentRecovery2d, RecoversTheDiagonalOfAFlatQuadrilateralByOneFlip)
{
    Delaunay2d delaunay = insertedOneByOne({{-4.0, 0.0}, {4.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}});
    ASSERT_FALSE(delaunay.mesh().findEdge(VertexId(0), VertexId(1)).isValid());
    const auto result = delaunay.recoverSegment(VertexId(0), VertexId(1));
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->recoveryFlips, 1u);
    EXPECT_TRUE(delaunay.mesh().isConstrained(delaunay.mesh().findEdge(VertexId(0), VertexId(1))));
    EXPECT_TRUE(isSound(delaunay));
    delaunay.unconstrainEdge(delaunay.mesh().findEdge(VertexId(0), VertexId(1)));
    EXPECT_FALSE(delaunay.mesh().findEdge(VertexId(0), VertexId(1)).isValid());
    EXPECT_TRUE(isSound(delaunay));
}

TEST(SegmentRecovery2d, RecoversTheLongDiagonalOfARandomCloudEitherWay)
{
    std::vector<Vec2> points = uniformPoints2d(3000, 21);
    points.push_back({-0.5, -0.4});
    points.push_back({1.5, 1.6});
    Delaunay2d forth = insertedOneByOne(points);
    Delaunay2d back = insertedOneByOne(points);
    ASSERT_TRUE(forth.recoverSegment(VertexId(3000), VertexId(3001)).hasValue());
    ASSERT_TRUE(back.recoverSegment(VertexId(3001), VertexId(3000)).hasValue());
    EXPECT_TRUE(isSound(forth));
    EXPECT_EQ(hashOf(forth), hashOf(back));
    EXPECT_EQ(forth.mesh().vertexCount(), 3002u);
    EXPECT_TRUE(forth.mesh().isConstrained(forth.mesh().findEdge(VertexId(3000), VertexId(3001))));
}

TEST(SegmentRecovery2d, PassesThroughTheVerticesOnTheSegment)
{
    Delaunay2d delaunay = insertedInBulk(gridPoints2d(400));
    const Location2d first = delaunay.locate({0.0, 0.0});
    const Location2d last = delaunay.locate({18.0, 6.0});
    const VertexId a = delaunay.mesh().triangle(first.triangle()).v[first.index()];
    const VertexId b = delaunay.mesh().triangle(last.triangle()).v[last.index()];
    ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
    const std::vector<VertexId>& chain = delaunay.lastSegment();
    ASSERT_EQ(chain.size(), 7u);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        EXPECT_EQ(delaunay.mesh().position(chain[i]),
                  (Vec2{3.0 * static_cast<double>(i), static_cast<double>(i)}));
        if (i == 0) continue;
        const EdgeLink edge = delaunay.mesh().findEdge(chain[i - 1], chain[i]);
        ASSERT_TRUE(edge.isValid());
        EXPECT_TRUE(delaunay.mesh().isConstrained(edge));
    }
    EXPECT_TRUE(isSound(delaunay));
}

TEST(SegmentRecovery2d, NamesBothSegmentsAndThePlaceWhereTheyCross)
{
    Delaunay2d delaunay =
        insertedOneByOne({{-2.0, 0.0}, {2.0, 0.0}, {0.5, -2.0}, {0.5, 2.0}, {-1.0, 3.0}, {1.7, -3.0}});
    ASSERT_TRUE(delaunay.recoverSegment(VertexId(0), VertexId(1)).hasValue());
    const std::uint64_t before = hashOf(delaunay);
    const auto result = delaunay.recoverSegment(VertexId(2), VertexId(3));
    ASSERT_FALSE(result.hasValue());
    EXPECT_EQ(result.error().code, ErrorCode::IntersectingConstraints);
    EXPECT_TRUE(result.error().entity == "segment 2-3 and segment 0-1" ||
                result.error().entity == "segment 2-3 and segment 1-0")
        << result.error().entity;
    ASSERT_TRUE(result.error().point.has_value());
    EXPECT_DOUBLE_EQ(result.error().point->x, 0.5);
    EXPECT_DOUBLE_EQ(result.error().point->y, 0.0);
    EXPECT_EQ(hashOf(delaunay), before);
    EXPECT_TRUE(isSound(delaunay));
}

TEST(SegmentRecovery2d, RefusesASegmentWithoutLengthAndOneInALine)
{
    Delaunay2d delaunay = insertedOneByOne({{0.0, 0.0}, {1.0, 0.0}});
    EXPECT_EQ(delaunay.recoverSegment(VertexId(0), VertexId(1)).error().code, ErrorCode::DegenerateInput);
    ASSERT_TRUE(delaunay.insert({0.0, 1.0}).hasValue());
    EXPECT_EQ(delaunay.recoverSegment(VertexId(1), VertexId(1)).error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(delaunay.recoverSegment(VertexId(1), VertexId(17)).error().code, ErrorCode::InvalidArgument);
}

/// Segments that do not cross: those edges of the triangulation of a sample that are drawn.
TEST(SegmentRecovery2d, RecoversSegmentsInEveryFamilyOfPoints)
{
    for (const PointFamily<Vec2>& family : pointFamilies2d()) {
        if (family.span != 2) continue;
        SCOPED_TRACE(family.name);
        const std::vector<Vec2> points = family.make(600, 4);
        Random random(5);
        std::vector<Vec2> sample;
        for (const Vec2 p : points) {
            if (random.below(10) == 0) sample.push_back(p);
        }
        const Delaunay2d coarse = insertedInBulk(sample);
        Delaunay2d fine;
        ASSERT_TRUE(fine.insertPoints(points).hasValue());
        const std::size_t vertexCount = fine.mesh().vertexCount();
        for (const auto& [a, b] : edgesOf(coarse.mesh())) {
            const auto from = fine.insert(coarse.mesh().position(a));
            const auto to = fine.insert(coarse.mesh().position(b));
            ASSERT_TRUE(fine.recoverSegment(from->vertex, to->vertex).hasValue());
            for (std::size_t i = 1; i < fine.lastSegment().size(); ++i) {
                const EdgeLink edge = fine.mesh().findEdge(fine.lastSegment()[i - 1], fine.lastSegment()[i]);
                ASSERT_TRUE(edge.isValid() && fine.mesh().isConstrained(edge));
            }
        }
        EXPECT_EQ(fine.mesh().vertexCount(), vertexCount);
        EXPECT_TRUE(isSound(fine));
    }
}

}  // namespace
}  // namespace mesher::test
