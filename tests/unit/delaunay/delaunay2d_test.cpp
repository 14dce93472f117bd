#include "delaunay/delaunay2d.h"

#include "support/degenerate_points.h"
#include "unit/delaunay/delaunay2d_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace mesher::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Delaunay2d, BeginsWithoutVertices)
{
    const Delaunay2d delaunay;
    EXPECT_EQ(delaunay.dimension(), -1);
    EXPECT_EQ(delaunay.locate({0.0, 0.0}).kind, Location2d::Kind::NoTriangles);
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, KeepsVerticesOnALineUntilOneLeavesIt)
{
    Delaunay2d delaunay;
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(delaunay.insert({1.0 * i, 2.0 * i}).hasValue());
    EXPECT_EQ(delaunay.dimension(), 1);
    EXPECT_EQ(delaunay.mesh().triangleCount(), 0u);
    EXPECT_EQ(delaunay.insert({3.0, 6.0})->outcome, InsertOutcome::Duplicate);
    ASSERT_TRUE(delaunay.insert({1.0, 0.0}).hasValue());
    EXPECT_EQ(delaunay.dimension(), 2);
    EXPECT_EQ(delaunay.mesh().vertexCount(), 6u);
    EXPECT_EQ(delaunay.mesh().triangleCount(), 10u);
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, GoesBackToALineWhenTheLastVertexOffItIsRemoved)
{
    Delaunay2d delaunay;
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(delaunay.insert({1.0 * i, 0.0}).hasValue());
    const std::uint64_t onLine = hashOf(delaunay);
    const VertexId apex = delaunay.insert({2.0, 1.0})->vertex;
    EXPECT_EQ(delaunay.remove(apex), RemovalOutcome::Removed);
    EXPECT_EQ(delaunay.dimension(), 1);
    EXPECT_EQ(hashOf(delaunay), onLine);
    EXPECT_TRUE(isSound(delaunay));
    ASSERT_TRUE(delaunay.insert({2.0, -1.0}).hasValue());
    EXPECT_EQ(delaunay.dimension(), 2);
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, RefusesPointsThatAreNotFiniteAndInsertsNone)
{
    Delaunay2d delaunay;
    const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 0.0}, {0.0, kInfinity}};
    const auto result = delaunay.insertPoints(points);
    ASSERT_FALSE(result.hasValue());
    EXPECT_EQ(result.error().code, ErrorCode::NonFinitePoint);
    EXPECT_EQ(result.error().entity, "point 2");
    EXPECT_EQ(delaunay.mesh().vertexCount(), 0u);
    EXPECT_EQ(delaunay.insert({std::numeric_limits<double>::quiet_NaN(), 0.0}).error().code,
              ErrorCode::NonFinitePoint);
}

TEST(Delaunay2d, RefusesPointsOutsideOfTheExactRange)
{
    Delaunay2d delaunay;
    EXPECT_EQ(delaunay.insert({1e300, 0.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(delaunay.insert({5e-324, 0.0}).error().code, ErrorCode::OutOfRange);
}

TEST(Delaunay2d, MapsEqualPointsToOneVertexAndCountsThem)
{
    Delaunay2d delaunay;
    const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 0.0}, {-0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}, {1.0, -0.0}};
    const auto result = delaunay.insertPoints(points);
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->duplicates, 3u);
    EXPECT_EQ(result->vertices[0], result->vertices[2]);
    EXPECT_EQ(result->vertices[1], result->vertices[4]);
    EXPECT_EQ(result->vertices[1], result->vertices[5]);
    EXPECT_EQ(delaunay.mesh().vertexCount(), 3u);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(delaunay.mesh().position(result->vertices[i]), points[i]);
    }
}

TEST(Delaunay2d, StopsWhenCancelledAndStaysSound)
{
    RunContext context;
    context.requestCancel();
    Delaunay2d delaunay;
    const auto result = delaunay.insertPoints(uniformPoints2d(5000, 1), &context);
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->stopReason, StopReason::Cancelled);
    EXPECT_EQ(delaunay.mesh().vertexCount(), 0u);
    EXPECT_FALSE(result->vertices[0].isValid());
}

TEST(Delaunay2d, LocatesPointsOfEveryKind)
{
    Delaunay2d delaunay;
    const VertexId origin = delaunay.insert({0.0, 0.0})->vertex;
    ASSERT_TRUE(delaunay.insert({4.0, 0.0}).hasValue());
    ASSERT_TRUE(delaunay.insert({0.0, 4.0}).hasValue());
    EXPECT_EQ(delaunay.locate({1.0, 1.0}).kind, Location2d::Kind::InTriangle);
    EXPECT_EQ(delaunay.locate({3.0, 3.0}).kind, Location2d::Kind::OutsideHull);
    EXPECT_EQ(delaunay.locate({-1.0, 0.0}).kind, Location2d::Kind::OutsideHull);
    const Location2d edge = delaunay.locate({2.0, 0.0});
    ASSERT_EQ(edge.kind, Location2d::Kind::OnEdge);
    EXPECT_EQ(delaunay.mesh().position(delaunay.mesh().apex(edge.edge)), (Vec2{0.0, 4.0}));
    const Location2d corner = delaunay.locate({0.0, 0.0});
    ASSERT_EQ(corner.kind, Location2d::Kind::OnVertex);
    EXPECT_EQ(delaunay.mesh().triangle(corner.triangle()).v[corner.index()], origin);
}

TEST(Delaunay2d, LocatesEveryVertexFromAnywhere)
{
    const Delaunay2d delaunay = insertedInBulk(uniformPoints2d(2000, 3));
    const Triangulation2d& mesh = delaunay.mesh();
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        const TriangleId hint(i * 7919u % static_cast<std::uint32_t>(mesh.triangleSlots()));
        const Location2d location = delaunay.locate(mesh.position(VertexId(i)), hint);
        ASSERT_EQ(location.kind, Location2d::Kind::OnVertex);
        ASSERT_EQ(mesh.triangle(location.triangle()).v[location.index()], VertexId(i));
    }
}

TEST(Delaunay2d, InsertsOnAConstrainedEdgeAndConstrainsBothHalves)
{
    Delaunay2d delaunay;
    const VertexId a = delaunay.insert({-1.0, 0.0})->vertex;
    const VertexId b = delaunay.insert({1.0, 0.0})->vertex;
    ASSERT_TRUE(delaunay.insert({0.0, 8.0}).hasValue());
    ASSERT_TRUE(delaunay.insert({0.0, -8.0}).hasValue());
    ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
    const auto insertion = delaunay.insert({0.25, 0.0});
    EXPECT_EQ(insertion->outcome, InsertOutcome::SplitConstraint);
    const Triangulation2d& mesh = delaunay.mesh();
    EXPECT_TRUE(mesh.isConstrained(mesh.findEdge(a, insertion->vertex)));
    EXPECT_TRUE(mesh.isConstrained(mesh.findEdge(insertion->vertex, b)));
    EXPECT_FALSE(mesh.findEdge(a, b).isValid());
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, SplitsAConstrainedHullEdge)
{
    Delaunay2d delaunay;
    const VertexId a = delaunay.insert({0.0, 0.0})->vertex;
    const VertexId b = delaunay.insert({4.0, 0.0})->vertex;
    ASSERT_TRUE(delaunay.insert({1.0, 3.0}).hasValue());
    ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
    EXPECT_EQ(delaunay.insert({1.0, 0.0})->outcome, InsertOutcome::SplitConstraint);
    EXPECT_TRUE(isSound(delaunay));
    EXPECT_EQ(delaunay.mesh().vertexCount(), 4u);
    EXPECT_EQ(delaunay.mesh().triangleCount(), 6u);
}

TEST(Delaunay2d, InsertsBeyondAConstrainedHullEdge)
{
    Delaunay2d delaunay;
    const VertexId a = delaunay.insert({0.0, 0.0})->vertex;
    const VertexId b = delaunay.insert({4.0, 0.0})->vertex;
    ASSERT_TRUE(delaunay.insert({2.0, 0.5}).hasValue());
    ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
    // Without the constraint this point would take the edge away.
    ASSERT_TRUE(delaunay.insert({2.0, -0.5}).hasValue());
    EXPECT_TRUE(delaunay.mesh().isConstrained(delaunay.mesh().findEdge(a, b)));
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, TreatsRegionsAsPropertiesOfTriangles)
{
    Delaunay2d delaunay;
    const VertexId a = delaunay.insert({0.0, 0.0})->vertex;
    const VertexId b = delaunay.insert({4.0, 0.0})->vertex;
    ASSERT_TRUE(delaunay.insert({2.0, 3.0}).hasValue());
    ASSERT_TRUE(delaunay.insert({2.0, -3.0}).hasValue());
    ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
    delaunay.setRegion(delaunay.locate({2.0, 1.0}).triangle(), RegionId(1));
    delaunay.setRegion(delaunay.locate({2.0, -1.0}).triangle(), RegionId(2));
    ASSERT_TRUE(delaunay.insert({1.0, 0.0}).hasValue());
    ASSERT_TRUE(delaunay.insert({2.0, 1.0}).hasValue());
    ASSERT_TRUE(delaunay.insert({2.0, -9.0}).hasValue());
    const Triangulation2d& mesh = delaunay.mesh();
    const auto regionAt = [&](Vec2 p) { return mesh.triangle(delaunay.locate(p).triangle()).region; };
    EXPECT_EQ(regionAt({0.5, 0.1}), RegionId(1));
    EXPECT_EQ(regionAt({2.5, 0.1}), RegionId(1));
    EXPECT_EQ(regionAt({0.5, -0.1}), RegionId(2));
    EXPECT_EQ(regionAt({1.0, -4.0}), RegionId(0));
}

TEST(Delaunay2d, FindsTheSameCavityWithoutChangingAnything)
{
    const Delaunay2d delaunay = insertedInBulk(uniformPoints2d(500, 5));
    const std::uint64_t before = hashOf(delaunay);
    Cavity2d cavity;
    for (const Vec2 p : uniformPoints2d(100, 6)) {
        delaunay.findCavity(p, delaunay.locate(p), cavity);
        EXPECT_EQ(cavity.boundary.size(), cavity.triangles.size() + 2);
        EXPECT_EQ(cavity.repairs, 0u);
    }
    EXPECT_EQ(hashOf(delaunay), before);
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, CommitsWhatTheCavityPromises)
{
    Delaunay2d delaunay = insertedInBulk(uniformPoints2d(200, 5));
    Delaunay2d direct = insertedInBulk(uniformPoints2d(200, 5));
    Cavity2d cavity;
    for (const Vec2 p : {Vec2{0.3, 0.4}, Vec2{2.0, 0.5}, Vec2{-1.0, -1.0}}) {
        delaunay.findCavity(p, delaunay.locate(p), cavity);
        const VertexId vertex = delaunay.commit(cavity);
        EXPECT_EQ(delaunay.mesh().position(vertex), p);
        ASSERT_TRUE(direct.insert(p).hasValue());
        EXPECT_EQ(hashOf(delaunay), hashOf(direct));
    }
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, ReportsTheConstrainedEdgesACavityMeets)
{
    Delaunay2d delaunay;
    const VertexId a = delaunay.insert({0.0, 0.0})->vertex;
    const VertexId b = delaunay.insert({4.0, 0.0})->vertex;
    ASSERT_TRUE(delaunay.insert({2.0, 3.0}).hasValue());
    ASSERT_TRUE(delaunay.insert({2.0, -3.0}).hasValue());
    ASSERT_TRUE(delaunay.recoverSegment(a, b).hasValue());
    const Vec2 p{2.0, 0.01};
    Cavity2d cavity;
    delaunay.findCavity(p, delaunay.locate(p), cavity);
    ASSERT_EQ(cavity.constrained.size(), 1u);
    EXPECT_EQ(delaunay.mesh().position(delaunay.mesh().apex(cavity.constrained[0])), (Vec2{2.0, -3.0}));
    EXPECT_EQ(cavity.triangles.size(), 1u);
}

TEST(Delaunay2d, CompactsDeadSlotsAway)
{
    Delaunay2d delaunay = insertedInBulk(uniformPoints2d(300, 9));
    for (std::uint32_t i = 0; i < 300; i += 2)
        EXPECT_EQ(delaunay.remove(VertexId(i)), RemovalOutcome::Removed);
    const std::uint64_t hash = hashOf(delaunay);
    const std::size_t bytes = delaunay.mesh().bytes();
    const Vec2 survivor = delaunay.mesh().position(VertexId(151));
    const auto map = delaunay.compact();
    EXPECT_FALSE(map.vertices[VertexId(150)].isValid());
    EXPECT_EQ(delaunay.mesh().position(map.vertices[VertexId(151)]), survivor);
    EXPECT_EQ(delaunay.mesh().vertexSlots(), 150u);
    EXPECT_EQ(delaunay.mesh().triangleSlots(), delaunay.mesh().triangleCount());
    EXPECT_LT(delaunay.mesh().bytes(), bytes * 6 / 10);
    EXPECT_EQ(hashOf(delaunay), hash);
    EXPECT_TRUE(isSound(delaunay));
    ASSERT_TRUE(delaunay.insert({0.5, 0.5}).hasValue());
    EXPECT_TRUE(isSound(delaunay));
}

TEST(Delaunay2d, ChangesTheGenerationOfChangedSlots)
{
    Delaunay2d delaunay = insertedInBulk(uniformPoints2d(50, 9));
    const Location2d location = delaunay.locate({0.5, 0.5});
    const auto generation = delaunay.mesh().triangle(location.triangle()).generation;
    ASSERT_TRUE(delaunay.insert({0.5, 0.5}).hasValue());
    EXPECT_NE(delaunay.mesh().triangle(location.triangle()).generation, generation);
}

TEST(Delaunay2d, UsesAHundredBytesAVertex)
{
    const Delaunay2d delaunay = insertedInBulk(uniformPoints2d(10000, 2));
    EXPECT_LE(delaunay.mesh().bytes(), 10000u * 100u);
}

TEST(MeshHash2d, TellsConstraintsAndPositionsApart)
{
    const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {2.0, 2.0}};
    Delaunay2d delaunay = insertedOneByOne(points);
    const std::uint64_t free = hashOf(delaunay);
    const auto edges = edgesOf(delaunay.mesh());
    std::set<std::uint64_t> hashes{free};
    for (const auto& [a, b] : edges) {
        const EdgeLink edge = delaunay.mesh().findEdge(a, b);
        delaunay.constrainEdge(edge);
        EXPECT_TRUE(hashes.insert(hashOf(delaunay)).second);
        delaunay.unconstrainEdge(edge);
        EXPECT_EQ(hashOf(delaunay), free);
    }
    EXPECT_TRUE(
        hashes.insert(hashOf(insertedOneByOne({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {2.0, 2.5}}))).second);
    EXPECT_EQ(hashes.size(), edges.size() + 2);
}

}  // namespace
}  // namespace mesher::test
