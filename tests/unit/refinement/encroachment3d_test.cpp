#include "refinement/encroachment3d.h"

#include "unit/refinement/refinement_fixture.h"

#include <algorithm>

namespace mesher::test {
namespace {

TEST(ProtectingBall, OfASegmentHasItsEndsOnIt)
{
    const ProtectingBall ball = ProtectingBall::ofSegment({0, 0, 0}, {2, 0, 0});
    EXPECT_DOUBLE_EQ(ball.depthOf({0, 0, 0}), 1.0);
    EXPECT_DOUBLE_EQ(ball.depthOf({1, 0, 0}), 0.0);
    EXPECT_FALSE(ball.contains({1, 1, 0}));
    EXPECT_TRUE(ball.contains({1, 0.99, 0}));
}

TEST(ProtectingBall, OfAFacetIsEquatorial)
{
    const auto ball = ProtectingBall::ofFacet({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    ASSERT_TRUE(ball.has_value());
    EXPECT_NEAR(ball->squaredRadius, 2.0, 1e-15);
    EXPECT_TRUE(ball->contains({1, 1, 1.4}));
    EXPECT_FALSE(ball->contains({1, 1, 1.42}));
    EXPECT_FALSE(ball->contains({2, 2, 0})) << "the fourth corner of a rectangle does not encroach";
    EXPECT_FALSE(ProtectingBall::ofFacet({0, 0, 0}, {1, 0, 0}, {2, 0, 0}).has_value());
}

struct BoxWithPoint
{
    SampledSolid box = sampledBox({1, 1, 1}, 2);

    Encroached3d at(const Vec3& point)
    {
        Delaunay3d& delaunay = *box.tetrahedralization.delaunay;
        const auto location = delaunay.locate(point);
        EXPECT_TRUE(location.hasValue());
        return findEncroached(delaunay.triangulation(), delaunay.findConflicts(point, location->tet),
                              delaunay.filter());
    }
};

TEST(FindEncroached, FindsNothingInTheMiddle)
{
    BoxWithPoint solid;
    const Encroached3d found = solid.at({0.5, 0.5, 0.51});
    EXPECT_FALSE(found.segment[0].isValid());
    EXPECT_FALSE(found.facet.isValid());
    EXPECT_FALSE(found.hasFacetBehind);
}

TEST(FindEncroached, FindsTheFacetBelow)
{
    BoxWithPoint solid;
    const Encroached3d found = solid.at({0.4, 0.37, 0.05});
    ASSERT_TRUE(found.facet.isValid());
    const Triangulation3d& mesh = solid.box.tetrahedralization.mesh();
    for (const VertexId v : mesh.faceVertices(found.facet)) EXPECT_EQ(mesh.position(v).z, 0.0);
    EXPECT_FALSE(found.segment[0].isValid());
}

TEST(FindEncroached, FindsTheSegmentBeside)
{
    BoxWithPoint solid;
    const Encroached3d found = solid.at({0.3, 0.05, 0.04});
    ASSERT_TRUE(found.segment[0].isValid());
    const Triangulation3d& mesh = solid.box.tetrahedralization.mesh();
    for (const VertexId v : found.segment) {
        EXPECT_EQ(mesh.position(v).y, 0.0);
        EXPECT_EQ(mesh.position(v).z, 0.0);
    }
}

TEST(FirstConstraintTowards, FindsTheFaceThatTheLineLeavesBy)
{
    SampledSolid torus = sampledTorus(2.0, 1.0, 20);
    const Delaunay3d& delaunay = *torus.tetrahedralization.delaunay;
    const Triangulation3d& mesh = delaunay.triangulation();
    int blocked = 0;
    for (const TetId tet : meshedTets(torus)) {
        // The other side of the ring is across the hole or around the bend, in any case through the surface.
        Vec3 centroid;
        for (const VertexId v : mesh.tet(tet).vertex) centroid = centroid + 0.25 * mesh.position(v);
        const TetFace face = firstConstraintTowards(mesh, tet, -1.0 * centroid, delaunay.filter());
        ASSERT_TRUE(face.isValid());
        EXPECT_TRUE(mesh.isFaceConstrained(face));
        EXPECT_EQ(mesh.region(face.tet()), RegionId(1u));
        EXPECT_EQ(mesh.region(mesh.neighbour(face).tet()), kExteriorRegion);
        ++blocked;
        if (sixfoldVolume(cornersOf(torus, tet)) < 1e-9) continue;  // too flat for a centroid inside
        EXPECT_FALSE(firstConstraintTowards(mesh, tet, centroid, delaunay.filter()).isValid());
    }
    EXPECT_GT(blocked, 100);
}

TEST(FindInTheWay, FindsTheFacetBeforeAPointOutsideWithoutCollectingAllThatIsInConflict)
{
    SampledSolid ball = sampledSphere(1.0, 2000);
    const ConstrainedTetrahedralization& t = ball.tetrahedralization;
    Delaunay3d& delaunay = *t.delaunay;
    const SurfaceMesh& surface = ball.splitter->mesh();
    const SurfaceFacet& facet = surface.facets[FacetId(0)];
    Vec3 middle;
    for (const NodeId node : facet.node) middle = middle + (1.0 / 3.0) * surface.nodes[node].position;
    // Behind the facet, and still in the sphere of the ball, which all tetrahedra have for theirs.
    const Vec3 outside = (t.scale * 0.5 * (1.0 + 1.0 / length(middle))) * middle;
    const TetId seed = delaunay.locate(t.scale * Vec3{0.01, 0.02, 0.03})->tet;
    ASSERT_GT(delaunay.findConflicts(outside, seed).tets.size(), kOrdinaryConflicts);

    const std::uint64_t work = delaunay.cavityWork();
    const Encroached3d found = findInTheWay(delaunay, seed, outside);
    EXPECT_EQ(delaunay.cavityWork() - work, kOrdinaryConflicts);
    ASSERT_TRUE(found.facet.isValid());
    EXPECT_TRUE(t.mesh().isFaceConstrained(found.facet));
    for (const NodeId node : facet.node) {
        const auto corners = t.mesh().faceVertices(found.facet);
        EXPECT_EQ(std::count(corners.begin(), corners.end(), t.vertexOf[node]), 1);
    }
}

}  // namespace
}  // namespace mesher::test
