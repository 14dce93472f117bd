#include "delaunay/vertex_removal2d.h"

#include "base/random.h"
#include "support/degenerate_points.h"
#include "unit/delaunay/delaunay2d_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mesher::test {
namespace {

TEST(VertexRemoval2d, UndoesInsertionInEveryFamilyOfPoints)
{
    for (const PointFamily<Vec2>& family : pointFamilies2d()) {
        SCOPED_TRACE(family.name);
        std::vector<Vec2> points = family.make(120, 8);
        Delaunay2d delaunay;
        std::vector<std::pair<VertexId, std::uint64_t>> history;
        for (const Vec2 p : points) {
            const std::uint64_t before = hashOf(delaunay);
            const auto insertion = delaunay.insert(p);
            if (insertion->outcome == InsertOutcome::Inserted)
                history.emplace_back(insertion->vertex, before);
        }
        while (!history.empty()) {
            ASSERT_EQ(delaunay.remove(history.back().first), RemovalOutcome::Removed);
            ASSERT_EQ(hashOf(delaunay), history.back().second) << history.size();
            ASSERT_TRUE(isSound(delaunay)) << history.size();
            history.pop_back();
        }
        EXPECT_EQ(delaunay.mesh().vertexCount(), 0u);
    }
}

TEST(VertexRemoval2d, LeavesTheTriangulationOfTheRest)
{
    for (const PointFamily<Vec2>& family : pointFamilies2d()) {
        SCOPED_TRACE(family.name);
        const std::vector<Vec2> points = family.make(400, 9);
        Delaunay2d delaunay;
        const auto inserted = delaunay.insertPoints(points);
        Random random(10);
        std::vector<VertexId> vertices = inserted->vertices;
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        shuffle(vertices, random);
        const std::size_t kept = vertices.size() / 4;
        std::vector<Vec2> rest;
        for (std::size_t i = 0; i < kept; ++i) rest.push_back(delaunay.mesh().position(vertices[i]));
        for (std::size_t i = kept; i < vertices.size(); ++i) {
            ASSERT_EQ(delaunay.remove(vertices[i]), RemovalOutcome::Removed);
        }
        EXPECT_TRUE(isSound(delaunay));
        EXPECT_EQ(hashOf(delaunay), hashOf(insertedInBulk(rest)));
    }
}

TEST(VertexRemoval2d, FillsTheStarOfAHub)
{
    std::vector<Vec2> points = circlePoints2d(3000, 2);
    points.push_back({0.01, 0.02});
    Delaunay2d delaunay = insertedOneByOne(points);
    EXPECT_EQ(delaunay.remove(VertexId(3000)), RemovalOutcome::Removed);
    points.pop_back();
    EXPECT_TRUE(isSound(delaunay));
    EXPECT_EQ(hashOf(delaunay), hashOf(insertedInBulk(points)));
}

TEST(VertexRemoval2d, KeepsVerticesOfConstrainedEdges)
{
    Delaunay2d delaunay = insertedInBulk(uniformPoints2d(100, 1));
    const auto [a, b] = edgesOf(delaunay.mesh()).front();
    ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
    const std::uint64_t before = hashOf(delaunay);
    EXPECT_EQ(delaunay.remove(a), RemovalOutcome::KeptConstrained);
    EXPECT_EQ(delaunay.remove(b, RemovalPolicy::StraightChainsToo), RemovalOutcome::KeptConstrained);
    EXPECT_EQ(hashOf(delaunay), before);
}

TEST(VertexRemoval2d, KeepsConstrainedEdgesOfALineWhoseLastTrianglesWouldGo)
{
    Delaunay2d delaunay = insertedOneByOne({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {1.0, 1.0}});
    ASSERT_TRUE(delaunay.recoverSegment(VertexId(0), VertexId(2)).hasValue());
    EXPECT_EQ(delaunay.remove(VertexId(3)), RemovalOutcome::KeptLastTriangles);
    EXPECT_TRUE(isSound(delaunay));
}

TEST(VertexRemoval2d, RestoresTheConstrainedTriangulation)
{
    for (const PointFamily<Vec2>& family : pointFamilies2d()) {
        if (family.span != 2) continue;
        SCOPED_TRACE(family.name);
        const std::vector<Vec2> points = family.make(80, 3);
        Delaunay2d delaunay;
        const auto vertices = delaunay.insertPoints(points)->vertices;
        Random random(6);
        for (int i = 0; i < 40; ++i) {
            const VertexId a = vertices[random.below(80)];
            const VertexId b = vertices[random.below(80)];
            // Segments that cross are refused, and nothing is changed.
            if (a != b) static_cast<void>(delaunay.recoverSegment(a, b).hasValue());
        }
        const Box2 box = Box2::of(points);
        for (int i = 0; i < 200; ++i) {
            const std::uint64_t before = hashOf(delaunay);
            const Vec2 p{random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)};
            const auto insertion = delaunay.insert(p);
            ASSERT_TRUE(insertion.hasValue());
            if (insertion->outcome != InsertOutcome::Inserted) continue;
            ASSERT_TRUE(isSound(delaunay));
            ASSERT_EQ(delaunay.remove(insertion->vertex), RemovalOutcome::Removed);
            ASSERT_EQ(hashOf(delaunay), before);
        }
        EXPECT_TRUE(isSound(delaunay));
    }
}

TEST(VertexRemoval2d, JoinsTheHalvesOfAStraightConstrainedChain)
{
    for (const double offset : {0.0, 20.0}) {
        // The chain runs through the cloud, or along its hull.
        Delaunay2d delaunay;
        const VertexId a = delaunay.insert({-8.0, -8.0})->vertex;
        const VertexId b = delaunay.insert({8.0, 8.0})->vertex;
        for (const Vec2 p : uniformPoints2d(200, 12)) {
            ASSERT_TRUE(delaunay.insert({16.0 * p.x - 8.0 + offset, 16.0 * p.y - 8.0 - offset}).hasValue());
        }
        ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
        const std::uint64_t before = hashOf(delaunay);
        std::vector<VertexId> splits;
        for (int i = 1; i < 32; ++i) {
            const auto insertion = delaunay.insert({0.5 * i - 8.0, 0.5 * i - 8.0});
            ASSERT_EQ(insertion->outcome, InsertOutcome::SplitConstraint);
            splits.push_back(insertion->vertex);
        }
        Random random(3);
        shuffle(splits, random);
        for (const VertexId split : splits) {
            ASSERT_EQ(delaunay.remove(split), RemovalOutcome::KeptConstrained);
            ASSERT_EQ(delaunay.remove(split, RemovalPolicy::StraightChainsToo), RemovalOutcome::Removed);
            ASSERT_TRUE(isSound(delaunay));
        }
        EXPECT_EQ(hashOf(delaunay), before);
    }
}

}  // namespace
}  // namespace mesher::test
