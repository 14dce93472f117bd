#include "delaunay/vertex_removal3d.h"

#include "delaunay/flips3d.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

namespace mesher::test {
namespace {

VertexId vertexAt(const Triangulation3d& mesh, const Vec3& place)
{
    for (const VertexId v : liveVertices(mesh)) {
        if (mesh.position(v) == place) return v;
    }
    return {};
}

bool isOnHull(const Triangulation3d& mesh, VertexId vertex)
{
    std::vector<TetId> star;
    mesh.collectStar(vertex, star);
    return std::any_of(star.begin(), star.end(), [&](TetId t) { return mesh.isGhostTet(t); });
}

TEST(VertexRemoval3d, LeavesTheTriangulationThatNeverHadThePoint)
{
    int hull = 0;
    int interior = 0;
    for (const auto& family : pointFamilies3d()) {
        if (family.span < 3) continue;
        SCOPED_TRACE(family.name);
        const std::vector<Vec3> points = family.make(70, 3);
        Delaunay3d delaunay;
        insertAll(delaunay, points);
        for (const VertexId chosen : liveVertices(delaunay.triangulation())) {
            const Vec3 place = delaunay.triangulation().position(chosen);
            isOnHull(delaunay.triangulation(), chosen) ? ++hull : ++interior;
            ASSERT_EQ(delaunay.remove(chosen), RemovalStatus::Removed);
            std::vector<Vec3> others = points;
            std::erase(others, place);
            ASSERT_EQ(meshHash3d(delaunay.triangulation()), hashOf(others));
            ASSERT_TRUE(isSoundTopology(delaunay.triangulation()));
            ASSERT_EQ(delaunay.insert(place)->status, InsertionStatus::Inserted);
        }
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points)) << "and back";
    }
    EXPECT_GT(hull, 100);
    EXPECT_GT(interior, 100);
}

TEST(VertexRemoval3d, EmptiesAGridInAnyOrder)
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        std::vector<Vec3> points = gridPoints3d(64);
        Random random(seed);
        shuffle(points, random);
        Delaunay3d delaunay;
        insertAll(delaunay, points);
        while (!points.empty()) {
            const VertexId v = vertexAt(delaunay.triangulation(), points.back());
            points.pop_back();
            ASSERT_EQ(delaunay.remove(v), RemovalStatus::Removed);
            ASSERT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points)) << points.size() << " left";
            ASSERT_TRUE(isSoundTopology(delaunay.triangulation()));
        }
    }
}

TEST(VertexRemoval3d, CutsOffAnApexOverAFlatBase)
{
    // All neighbours of the apex lie in one plane; below it there are other points.
    std::vector<Vec3> points = gridPoints3d(27);
    const std::uint64_t without = hashOf(points);
    for (const Vec3& apex : {Vec3{1, 1, 3}, Vec3{0.75, 1.25, 2.5}, Vec3{1, 1, -7}, Vec3{-0.5, 1, 1}}) {
        Delaunay3d delaunay;
        insertAll(delaunay, points);
        const VertexId v = delaunay.insert(apex)->vertex;
        EXPECT_EQ(delaunay.remove(v), RemovalStatus::Removed);
        EXPECT_EQ(delaunay.dimension(), 3);
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), without);
        EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
    }
}

TEST(VertexRemoval3d, CutsOffAnApexOfThreeNeighbours)
{
    // Every numbering of the base: which corner of a hole face is the ghost depends on it.
    std::vector<Vec3> base = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (const bool isMirrored : {false, true}) {
        std::vector<Vec3> points = base;
        if (isMirrored) std::swap(points[0], points[1]);
        points.push_back({0.25, 0.25, -1});
        Delaunay3d delaunay;
        insertEach(delaunay, points);
        const VertexId apex = delaunay.insert({0.25, 0.25, 1})->vertex;
        EXPECT_EQ(delaunay.remove(apex), RemovalStatus::Removed);
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points));
        EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
        EXPECT_EQ(delaunay.triangulation().tetCount(), 5u);
    }
}

TEST(VertexRemoval3d, RemovesAHub)
{
    std::vector<Vec3> points = spherePoints3d(3000, 1);
    const std::uint64_t without = hashOf(points);
    points.push_back({0, 0, 0});
    Delaunay3d delaunay;
    const BulkInsertion3d inserted = insertAll(delaunay, points);
    std::vector<TetId> star;
    delaunay.triangulation().collectStar(inserted.vertex.back(), star);
    EXPECT_GT(star.size(), 5000u);
    EXPECT_EQ(delaunay.remove(inserted.vertex.back()), RemovalStatus::Removed);
    EXPECT_EQ(meshHash3d(delaunay.triangulation()), without);
    EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
}

class VertexRemoval3dBesideConstraints : public testing::Test
{
protected:
    VertexRemoval3dBesideConstraints()
    {
        insertAll(delaunay_, uniformPoints3d(60, 8));
        for (const VertexId v : liveVertices(mesh())) {
            if (!isOnHull(mesh(), v)) inner_ = v;
        }
        mesh().collectStar(inner_, star_);
    }
    Triangulation3d& mesh() { return delaunay_.triangulation(); }
    TetFace linkFace(std::size_t i) { return {star_[i], mesh().slotOf(star_[i], inner_)}; }

    Delaunay3d delaunay_;
    VertexId inner_;
    std::vector<TetId> star_;
};

TEST_F(VertexRemoval3dBesideConstraints, IsRefusedForTheEndsOfConstraints)
{
    for (const bool isFace : {false, true}) {
        const int slot = mesh().slotOf(star_[0], inner_);
        const int other = (slot + 1) % 4;
        if (isFace) {
            mesh().setFaceConstrained({star_[0], other}, true);
        } else {
            mesh().setEdgeConstrained(star_[0], inner_, mesh().vertex(star_[0], other), true);
        }
        const std::uint64_t before = stateHash(mesh());
        EXPECT_EQ(delaunay_.remove(inner_), RemovalStatus::OnConstraint);
        EXPECT_EQ(stateHash(mesh()), before);
        if (isFace) {
            mesh().setFaceConstrained({star_[0], other}, false);
        } else {
            mesh().setEdgeConstrained(star_[0], inner_, mesh().vertex(star_[0], other), false);
        }
    }
    EXPECT_EQ(delaunay_.remove(inner_), RemovalStatus::Removed);
}

TEST_F(VertexRemoval3dBesideConstraints, KeepsThoseAroundTheHole)
{
    const auto face = mesh().faceVertices(linkFace(0));
    mesh().setFaceConstrained(linkFace(0), true);
    mesh().setEdgeConstrained(star_[0], face[0], face[1], true);
    for (const TetId t : finiteTets(mesh())) mesh().setRegion(t, RegionId(3u));
    ASSERT_EQ(delaunay_.remove(inner_), RemovalStatus::Removed);
    EXPECT_TRUE(isSoundTopology(mesh()));
    EXPECT_TRUE(mesh().isFaceConstrained(mesh().findFace(face[0], face[1], face[2])));
    const TetId t = mesh().findEdge(face[0], face[1]);
    EXPECT_TRUE(
        mesh().isEdgeConstrained(t, kEdgeOfSlots[mesh().slotOf(t, face[0])][mesh().slotOf(t, face[1])]));
    for (const TetId tet : finiteTets(mesh())) EXPECT_EQ(mesh().region(tet), RegionId(3u));
}

TEST(VertexRemoval3d, IsBlockedByAHoleThatDelaunayTetrahedraDoNotFill)
{
    // Flips make links with faces that are no Delaunay faces of their vertices.
    std::uint64_t blocked = 0;
    std::uint64_t counted = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Delaunay3d delaunay;
        insertAll(delaunay, uniformPoints3d(40, seed));
        Triangulation3d& mesh = delaunay.triangulation();
        TetReplacement3d replacement(mesh);
        for (int i = 0; i < 12; ++i) {
            for (const TetId tet : finiteTets(mesh)) {
                if (!mesh.isAlive(tet) || mesh.isGhostTet(tet)) continue;
                const std::optional<Flip3d> flip = evaluateFlip23(mesh, {tet, i % 4});
                if (!flip) continue;
                applyFlip(replacement, *flip);
                break;
            }
        }
        for (const VertexId v : liveVertices(mesh)) {
            const std::uint64_t before = stateHash(mesh);
            const RemovalStatus status = delaunay.remove(v);
            if (status == RemovalStatus::Removed) {
                ASSERT_TRUE(isSoundTopology(mesh));
                continue;
            }
            ASSERT_EQ(status, RemovalStatus::Blocked);
            EXPECT_EQ(stateHash(mesh), before);
            ++blocked;
        }
        counted += delaunay.counters().blockedRemovals;
    }
    EXPECT_GT(blocked, 5u);
    EXPECT_EQ(counted, blocked);
}

TEST(VertexRemoval3d, KeepsTheTetrahedraThatHoldConstraints)
{
    const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.25, 0.25, 1}};
    for (const bool isFace : {false, true}) {
        Delaunay3d delaunay;
        insertEach(delaunay, points);
        Triangulation3d& mesh = delaunay.triangulation();
        const VertexId a = vertexAt(mesh, points[0]), b = vertexAt(mesh, points[1]),
                       apex = vertexAt(mesh, points[4]);
        const TetId tet = mesh.findEdge(a, b);
        if (isFace) {
            for (const TetId t : finiteTets(mesh)) mesh.setFaceConstrained({t, mesh.slotOf(t, apex)}, true);
        } else {
            mesh.setEdgeConstrained(tet, a, b, true);
        }
        const std::uint64_t before = stateHash(mesh);
        EXPECT_EQ(delaunay.remove(apex), RemovalStatus::Blocked)
            << "without it no tetrahedron could hold the constraint";
        EXPECT_EQ(stateHash(mesh), before);
        EXPECT_EQ(delaunay.dimension(), 3);
    }
}

}  // namespace
}  // namespace mesher::test
