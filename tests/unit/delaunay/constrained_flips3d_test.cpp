#include "delaunay/constrained_flips3d.h"

#include "delaunay/facet_flip3d.h"
#include "delaunay/flips3d.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mesher::test {
namespace {

std::vector<Vec3> randomPoints(int count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back({random.between(0.0, 1.0), random.between(0.0, 1.0), random.between(0.0, 1.0)});
    return points;
}

/// Makes flips that nobody asked for.
void spoil(Triangulation3d& mesh, int flips)
{
    TetReplacement3d replacement(mesh);
    int made = 0;
    for (std::uint32_t i = 0; i < mesh.tetLimit() && made < flips; ++i) {
        for (int face = 0; face < 4; ++face) {
            if (!mesh.isAlive(TetId(i)) || mesh.isGhostTet(TetId(i))) continue;
            const auto flip = evaluateFlip23(mesh, {TetId(i), face});
            if (!flip) continue;
            applyFlip(replacement, *flip);
            ++made;
        }
    }
}

TEST(ConstrainedFlips3d, MakeASpoiltTriangulationTheDelaunayOneAgain)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Delaunay3d delaunay;
        insertAll(delaunay, randomPoints(200, seed));
        const std::uint64_t hash = meshHash3d(delaunay.triangulation());
        spoil(delaunay.triangulation(), 60);
        ASSERT_GT(countNonDelaunayFaces(delaunay.triangulation(), DelaunayPart::Everywhere), 0u);
        RunContext context;
        Budget budget({}, context);
        ConstrainedFlips3d flips(delaunay, DelaunayPart::Everywhere);
        flips.pushAll(budget);
        flips.flipAndFill(budget);
        EXPECT_TRUE(flips.stuck().empty());
        EXPECT_EQ(countNonDelaunayFaces(delaunay.triangulation(), DelaunayPart::Everywhere), 0u);
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hash);
        EXPECT_TRUE(checkTopology3d(delaunay.triangulation()).isValid());
    }
}

TEST(ConstrainedFlips3d, LeaveOtherPartsAlone)
{
    Delaunay3d delaunay;
    insertAll(delaunay, randomPoints(200, 3));
    Triangulation3d& mesh = delaunay.triangulation();
    spoil(mesh, 60);
    const std::uint64_t before = countNonDelaunayFaces(mesh, DelaunayPart::Everywhere);
    ASSERT_EQ(countNonDelaunayFaces(mesh, DelaunayPart::Inside), 0u) << "all of it is exterior";
    RunContext context;
    Budget budget({}, context);
    ConstrainedFlips3d flips(delaunay, DelaunayPart::Inside);
    flips.pushAll(budget);
    flips.flipAndFill(budget);
    EXPECT_EQ(flips.counts().flips, 0u);
    EXPECT_EQ(countNonDelaunayFaces(mesh, DelaunayPart::Everywhere), before);
}

/// A square with its diagonals, and a vertex on either side.
class FacetPair : public testing::Test
{
protected:
    void SetUp() override
    {
        insertAll(delaunay_, std::vector<Vec3>{
                                 {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0.1, 0.2, 2}, {0, 0, -2}});
        for (const VertexId v : liveVertices(mesh_)) {
            if (mesh_.position(v).z == 0.0) corner_.push_back(v);
        }
        std::sort(corner_.begin(), corner_.end(),
                  [&](VertexId a, VertexId b) { return angleOf(a) < angleOf(b); });
        if (!mesh_.findEdge(corner_[0], corner_[2]).isValid())
            std::rotate(corner_.begin(), corner_.begin() + 1, corner_.end());
        for (const VertexId apex : {corner_[1], corner_[3]}) {
            const TetFace face = mesh_.findFace(corner_[0], corner_[2], apex);
            ASSERT_TRUE(face.isValid());
            mesh_.setFaceConstrained(face, true);
        }
    }
    [[nodiscard]] double angleOf(VertexId v) const
    {
        return std::atan2(mesh_.position(v).y, mesh_.position(v).x);
    }
    bool flip() { return flipFacetPair(mesh_, {corner_[0], corner_[2]}, {corner_[1], corner_[3]}, changed_); }

    Delaunay3d delaunay_;
    Triangulation3d& mesh_ = delaunay_.triangulation();
    std::vector<VertexId> corner_;
    std::vector<TetId> changed_;
};

TEST_F(FacetPair, GetsItsOtherDiagonalWithTheConstraint)
{
    ASSERT_TRUE(flip());
    EXPECT_TRUE(checkTopology3d(mesh_).isValid());
    EXPECT_EQ(changed_.size(), 4u);
    EXPECT_FALSE(mesh_.findEdge(corner_[0], corner_[2]).isValid());
    for (const VertexId apex : {corner_[0], corner_[2]}) {
        const TetFace face = mesh_.findFace(corner_[1], corner_[3], apex);
        ASSERT_TRUE(face.isValid());
        EXPECT_TRUE(mesh_.isFaceConstrained(face));
        EXPECT_TRUE(mesh_.isFaceConstrained(mesh_.neighbour(face)));
    }
}

TEST_F(FacetPair, KeepsADiagonalThatIsConstrainedItself)
{
    mesh_.setEdgeConstrained(mesh_.findEdge(corner_[0], corner_[2]), corner_[0], corner_[2], true);
    const std::uint64_t hash = meshHash3d(mesh_);
    EXPECT_FALSE(flip());
    EXPECT_EQ(meshHash3d(mesh_), hash);
}

/// Two facets over the diagonal of a quadrilateral, one vertex inside and two outside beside the diagonal.
class FacetPairBesideMore : public testing::Test
{
protected:
    /// The fourth corner is `height` above the plane of the others.
    void make(double height)
    {
        const std::vector<Vec3> points{{-1, -1, 0}, {1.2, -1.2, 0},   {1, 1, 0},       {-1.2, 1.2, height},
                                       {0, 0, -3},  {0.4, -0.4, 1.5}, {-0.4, 0.4, 1.5}};
        insertAll(delaunay_, points);
        for (const Vec3& point : points) {
            for (const VertexId v : liveVertices(mesh_)) {
                if (mesh_.position(v) == point) vertex_.push_back(v);
            }
        }
        for (const VertexId apex : {vertex_[1], vertex_[3]}) {
            const TetFace face = mesh_.findFace(vertex_[0], vertex_[2], apex);
            ASSERT_TRUE(face.isValid());
            mesh_.setFaceConstrained(face, true);
        }
        for (const TetId tet : finiteTets(mesh_)) {
            if (mesh_.slotOf(tet, vertex_[4]) >= 0) mesh_.setRegion(tet, kInside);
        }
        ASSERT_EQ(tetsAtDiagonal(kExteriorRegion).size(), 3u);
    }
    [[nodiscard]] std::vector<TetId> tetsAtDiagonal(RegionId region) const
    {
        std::vector<TetId> ring;
        mesh_.collectEdgeRing(mesh_.findEdge(diagonal()[0], diagonal()[1]), diagonal()[0], diagonal()[1],
                              ring);
        std::erase_if(ring, [&](TetId tet) { return mesh_.region(tet) != region; });
        return ring;
    }
    [[nodiscard]] std::array<VertexId, 2> diagonal() const { return {vertex_[0], vertex_[2]}; }
    bool flip() { return flipFacetPair(mesh_, diagonal(), {vertex_[1], vertex_[3]}, changed_); }

    static constexpr RegionId kInside{1};

    Delaunay3d delaunay_;
    Triangulation3d& mesh_ = delaunay_.triangulation();
    std::vector<VertexId> vertex_;
    std::vector<TetId> changed_;
};

TEST_F(FacetPairBesideMore, FlipsOnceAVertexOutsideHasClearedTheDiagonal)
{
    make(0.0);
    ASSERT_FALSE(flip());
    const auto centre = clearBesideEdge(mesh_, diagonal(), kExteriorRegion);
    ASSERT_TRUE(centre.has_value());
    EXPECT_TRUE(checkTopology3d(mesh_).isValid());
    EXPECT_GT(mesh_.position(*centre).z, 0.0);
    EXPECT_EQ(tetsAtDiagonal(kExteriorRegion).size(), 2u);
    EXPECT_EQ(tetsAtDiagonal(kInside).size(), 2u);
    EXPECT_TRUE(flip());
    EXPECT_TRUE(checkTopology3d(mesh_).isValid());
}

TEST_F(FacetPairBesideMore, GetsTheTetrahedronOfItsCornersWhereItBends)
{
    make(0x1p-40);
    ASSERT_TRUE(clearBesideEdge(mesh_, diagonal(), kExteriorRegion).has_value());
    EXPECT_TRUE(checkTopology3d(mesh_).isValid());
    const std::vector<TetId> outside = tetsAtDiagonal(kExteriorRegion);
    ASSERT_EQ(outside.size(), 1u);
    EXPECT_GE(mesh_.slotOf(outside.front(), vertex_[1]), 0);
    EXPECT_GE(mesh_.slotOf(outside.front(), vertex_[3]), 0);
}

TEST_F(FacetPairBesideMore, StaysAsItIsOnASideWithTwoTetrahedra)
{
    make(0.0);
    const std::uint64_t hash = meshHash3d(mesh_);
    EXPECT_FALSE(clearBesideEdge(mesh_, diagonal(), kInside).has_value());
    EXPECT_EQ(meshHash3d(mesh_), hash);
}

}  // namespace
}  // namespace mesher::test
