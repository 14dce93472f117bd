#include "property/noncrossing_segments.h"
#include "support/degenerate_points.h"
#include "unit/delaunay/delaunay2d_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mesher::test {
namespace {

using VertexPair = std::pair<VertexId, VertexId>;

std::size_t constrainedEdgeCount(const Triangulation2d& mesh)
{
    const auto edges = edgesOf(mesh);
    return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const VertexPair& edge) {
        return mesh.isConstrained(mesh.findEdge(edge.first, edge.second));
    }));
}

TEST(SegmentRecovery2dProperty, RecoversAHundredThousandSegmentsByFlipsAlone)
{
    constexpr std::size_t kSegments = 100000;
    constexpr std::size_t kFreePoints = 50000;
    const auto segments = nonCrossingSegments(kSegments, 1);
    std::vector<Vec2> points;
    for (const auto& [from, to] : segments) {
        points.push_back(from);
        points.push_back(to);
    }
    for (const Vec2 p : uniformPoints2d(kFreePoints, 2)) points.push_back(p);

    Delaunay2d delaunay;
    const auto vertices = delaunay.insertPoints(points)->vertices;
    const std::size_t vertexCount = delaunay.mesh().vertexCount();
    const std::size_t triangleCount = delaunay.mesh().triangleCount();
    std::size_t missing = 0;
    std::size_t flips = 0;
    for (std::size_t i = 0; i < kSegments; ++i) {
        const auto result = delaunay.recoverSegment(vertices[2 * i], vertices[2 * i + 1]);
        ASSERT_TRUE(result.hasValue()) << describe(result.error());
        ASSERT_EQ(delaunay.lastSegment().size(), 2u);
        if (result->recoveryFlips > 0) ++missing;
        flips += result->recoveryFlips;
    }
    EXPECT_GT(missing, kSegments / 5) << "the segments are too short to test anything";
    EXPECT_GT(flips, kSegments);
    EXPECT_EQ(delaunay.mesh().vertexCount(), vertexCount);
    EXPECT_EQ(delaunay.mesh().triangleCount(), triangleCount);
    for (std::size_t i = 0; i < kSegments; ++i) {
        const EdgeLink edge = delaunay.mesh().findEdge(vertices[2 * i], vertices[2 * i + 1]);
        ASSERT_TRUE(edge.isValid() && delaunay.mesh().isConstrained(edge)) << i;
    }
    EXPECT_EQ(constrainedEdgeCount(delaunay.mesh()), kSegments);
    EXPECT_TRUE(isSound(delaunay));
}

TEST(SegmentRecovery2dProperty, DoesNotDependOnTheOrderOfTheSegments)
{
    const auto segments = nonCrossingSegments(2000, 3);
    std::vector<Vec2> points;
    for (const auto& [from, to] : segments) {
        points.push_back(from);
        points.push_back(to);
    }
    Random random(4);
    std::vector<std::size_t> order(segments.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::uint64_t expected = 0;
    for (int round = 0; round < 4; ++round) {
        Delaunay2d delaunay;
        const auto vertices = delaunay.insertPoints(points)->vertices;
        for (const std::size_t i : order) {
            ASSERT_TRUE(delaunay.recoverSegment(vertices[2 * i], vertices[2 * i + 1]).hasValue());
        }
        ASSERT_TRUE(delaunay.insertPoints(uniformPoints2d(3000, 5)).hasValue());
        EXPECT_TRUE(isSound(delaunay));
        if (round == 0) expected = hashOf(delaunay);
        EXPECT_EQ(hashOf(delaunay), expected);
        shuffle(order, random);
    }
}

TEST(SegmentRecovery2dProperty, GivesTheDelaunayTriangulationBackWhenAllEdgesAreFree)
{
    const auto segments = nonCrossingSegments(2000, 6);
    std::vector<Vec2> points;
    for (const auto& [from, to] : segments) {
        points.push_back(from);
        points.push_back(to);
    }
    Delaunay2d delaunay;
    const auto vertices = delaunay.insertPoints(points)->vertices;
    const std::uint64_t free = hashOf(delaunay);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        ASSERT_TRUE(delaunay.recoverSegment(vertices[2 * i], vertices[2 * i + 1]).hasValue());
    }
    EXPECT_NE(hashOf(delaunay), free);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        delaunay.unconstrainEdge(delaunay.mesh().findEdge(vertices[2 * i], vertices[2 * i + 1]));
    }
    EXPECT_EQ(hashOf(delaunay), free);
}

}  // namespace
}  // namespace mesher::test
