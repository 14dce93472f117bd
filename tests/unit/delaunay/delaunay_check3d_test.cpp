#include "delaunay/delaunay_check3d.h"

#include "delaunay/flips3d.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <map>

namespace mesher::test {
namespace {

/// A sound triangulation that each test damages in one way.
class DelaunayCheck3d : public testing::Test
{
protected:
    DelaunayCheck3d()
    {
        insertAll(delaunay_, uniformPoints3d(60, 4));
        tet_ = finiteTets(mesh())[25];
    }

    Triangulation3d& mesh() { return delaunay_.triangulation(); }

    void expectProblem(const std::string& part)
    {
        const CheckReport report = checkTopology3d(mesh());
        EXPECT_FALSE(report.isValid());
        EXPECT_NE(report.problem.find(part), std::string::npos) << report.problem;
    }

    TetId ghostTet()
    {
        for (const TetId tet : liveTets(mesh())) {
            if (mesh().isGhostTet(tet)) return tet;
        }
        return {};
    }

    Delaunay3d delaunay_;
    TetId tet_;
};

TEST_F(DelaunayCheck3d, AcceptsASoundTriangulation)
{
    EXPECT_TRUE(isSoundTopology(mesh()));
    EXPECT_TRUE(isDelaunay(mesh(), DelaunayScope::Local));
    EXPECT_TRUE(isDelaunay(mesh(), DelaunayScope::Global));
    EXPECT_TRUE(isSoundTopology(Triangulation3d()));
}

TEST_F(DelaunayCheck3d, DetectsALinkThatIsNotSymmetric)
{
    mesh().tet(tet_).neighbour[1] = mesh().tet(tet_).neighbour[2];
    expectProblem("not linked back");
}

TEST_F(DelaunayCheck3d, DetectsALinkToADeadSlot)
{
    const TetId spare = mesh().allocateTet();
    mesh().freeTet(spare);
    mesh().tet(liveTets(mesh()).front()).neighbour[3] = TetFace(spare, 0);
    expectProblem("linked to nothing");
}

TEST_F(DelaunayCheck3d, DetectsALinkToAnotherFace)
{
    const TetFace a(tet_, 0);
    const TetFace b = mesh().neighbour(tet_, 1);
    mesh().link(a, {b.tet(), (b.face() + 1) % 4});
    expectProblem("other vertices");
}

TEST_F(DelaunayCheck3d, DetectsAFoldedFace)
{
    // Two ghosts exchange orientation only: all else stays right, links included.
    const TetId ghost = ghostTet();
    std::swap(mesh().tet(ghost).vertex[0], mesh().tet(ghost).vertex[1]);
    std::swap(mesh().tet(ghost).neighbour[0], mesh().tet(ghost).neighbour[1]);
    for (int i = 0; i < 2; ++i) mesh().link({ghost, i}, mesh().neighbour(ghost, i));
    expectProblem("other vertices or sense");
}

TEST_F(DelaunayCheck3d, DetectsATetrahedronTurnedInsideOut)
{
    VertexId inner;
    for (const VertexId v : liveVertices(mesh())) {
        std::vector<TetId> star;
        mesh().collectStar(v, star);
        if (std::none_of(star.begin(), star.end(), [&](TetId t) { return mesh().isGhostTet(t); })) inner = v;
    }
    ASSERT_TRUE(inner.isValid());
    mesh().setPosition(inner, {5, 5, 5});
    expectProblem("not positively oriented");
}

TEST_F(DelaunayCheck3d, DetectsAFlatTetrahedron)
{
    const auto& v = mesh().tet(tet_).vertex;
    mesh().setPosition(v[3], 0.5 * (mesh().position(v[0]) + mesh().position(v[1])));
    EXPECT_FALSE(checkTopology3d(mesh()).isValid());
}

TEST_F(DelaunayCheck3d, DetectsAFaceConstrainedOnOneSideOnly)
{
    mesh().state(tet_).flags |= tet_flag::face(2);
    expectProblem("one side only");
}

TEST_F(DelaunayCheck3d, DetectsAnEdgeConstrainedInSomeTetrahedraOnly)
{
    mesh().setEdgeConstrained(tet_, mesh().vertex(tet_, 0), mesh().vertex(tet_, 1), true);
    EXPECT_TRUE(isSoundTopology(mesh()));
    mesh().state(tet_).flags = static_cast<std::uint16_t>(mesh().flags(tet_) & ~tet_flag::edge(0));
    expectProblem("some of its tetrahedra only");
}

TEST_F(DelaunayCheck3d, DetectsAWrongIncidentTetrahedron)
{
    const VertexId v = mesh().vertex(tet_, 0);
    for (const TetId other : liveTets(mesh())) {
        if (mesh().slotOf(other, v) < 0) mesh().setIncidentTet(v, other);
    }
    expectProblem("has no incident tetrahedron");
}

TEST_F(DelaunayCheck3d, DetectsAnIsolatedVertex)
{
    const VertexId v = mesh().addVertex({0.5, 0.5, 0.5});
    mesh().setIncidentTet(v, tet_);
    EXPECT_FALSE(checkTopology3d(mesh()).isValid());
}

TEST_F(DelaunayCheck3d, DetectsADeadAMisplacedAndARepeatedVertex)
{
    tet_ = liveTets(mesh()).front();  // told before its neighbours notice
    const auto saved = mesh().tet(tet_).vertex;
    mesh().tet(tet_).vertex[0] = VertexId(1000000u);
    expectProblem("dead or misplaced");
    mesh().tet(tet_).vertex[0] = kGhostVertex;
    expectProblem("dead or misplaced");
    mesh().tet(tet_).vertex[0] = saved[1];
    expectProblem("vertex twice");
}

TEST_F(DelaunayCheck3d, DetectsAnEulerCharacteristicThatIsNotZero)
{
    // A second copy of the 3-sphere, sound in itself.
    const std::vector<TetId> tets = liveTets(mesh());
    std::map<VertexId, VertexId> copyOf;
    for (const VertexId v : liveVertices(mesh())) copyOf[v] = mesh().addVertex(mesh().position(v));
    std::map<TetId, TetId> tetCopy;
    for (const TetId t : tets) tetCopy[t] = mesh().allocateTet();
    for (const TetId t : tets) {
        TetRecord record = mesh().tet(t);
        for (VertexId& v : record.vertex) v = isGhost(v) ? v : copyOf[v];
        for (TetFace& n : record.neighbour) n = TetFace(tetCopy[n.tet()], n.face());
        mesh().tet(tetCopy[t]) = record;
    }
    mesh().rebuildIncidentTets();
    expectProblem("Euler");
}

TEST_F(DelaunayCheck3d, DetectsAScratchMark)
{
    mesh().state(tet_).flags |= tet_flag::kInCavity;
    expectProblem("scratch mark");
}

TEST_F(DelaunayCheck3d, DetectsRegionsThatNothingSeparates)
{
    mesh().setRegion(tet_, RegionId(1u));
    expectProblem("separates two regions");
    for (int i = 0; i < 4; ++i) mesh().setFaceConstrained({tet_, i}, true);
    EXPECT_TRUE(isSoundTopology(mesh()));
}

TEST_F(DelaunayCheck3d, DetectsAFlipThatIsNotDelaunayInBothScopes)
{
    TetReplacement3d replacement(mesh());
    for (const TetId tet : finiteTets(mesh())) {
        for (int i = 0; i < 4; ++i) {
            const std::optional<Flip3d> flip = evaluateFlip23(mesh(), {tet, i});
            if (!flip) continue;
            applyFlip(replacement, *flip);
            EXPECT_TRUE(isSoundTopology(mesh()));
            const CheckReport local = checkDelaunay3d(mesh(), DelaunayScope::Local);
            const CheckReport global = checkDelaunay3d(mesh(), DelaunayScope::Global);
            EXPECT_FALSE(local.isValid());
            EXPECT_FALSE(global.isValid());
            EXPECT_NE(local.problem.find("not locally Delaunay"), std::string::npos);
            EXPECT_NE(global.problem.find("lies in the sphere"), std::string::npos);
            return;
        }
    }
    FAIL() << "no face could be flipped";
}

TEST_F(DelaunayCheck3d, DetectsAFlippedPairOfTheHull)
{
    // The top of a cube: both diagonals have the same spheres, only the perturbation tells which it is.
    Delaunay3d cube;
    insertAll(cube, gridPoints3d(8));
    insertEach(cube, std::vector<Vec3>{{0.25, 0.5, 0.25}});
    Triangulation3d& mesh = cube.triangulation();
    TetReplacement3d replacement(mesh);
    for (const TetId tet : finiteTets(mesh)) {
        for (int edge = 0; edge < 6; ++edge) {
            const std::optional<Flip3d> flip = evaluateFlip22(mesh, tet, edge);
            if (!flip) continue;
            applyFlip(replacement, *flip);
            EXPECT_TRUE(isSoundTopology(mesh));
            EXPECT_FALSE(checkDelaunay3d(mesh, DelaunayScope::Local).isValid());
            EXPECT_FALSE(checkDelaunay3d(mesh, DelaunayScope::Global).isValid());
            return;
        }
    }
    FAIL() << "no hull edge could be flipped";
}

TEST_F(DelaunayCheck3d, DetectsAHullThatIsNotConvex)
{
    const TetId ghost = ghostTet();
    Vec3 middle;
    for (unsigned i = 0; i < 3; ++i)
        middle = middle + (1.0 / 3.0) * mesh().position(mesh().tet(ghost).vertex[i]);
    const VertexId corner = mesh().tet(ghost).vertex[0];
    // Slightly inwards: the tetrahedra stay positively oriented.
    const Vec3 inwards = Vec3{0.5, 0.5, 0.5} - mesh().position(corner);
    mesh().setPosition(corner, mesh().position(corner) + 0.02 * inwards);
    const bool isTopologySound = checkTopology3d(mesh()).isValid();
    EXPECT_TRUE(!isTopologySound || !checkDelaunay3d(mesh(), DelaunayScope::Local).isValid());
}

TEST_F(DelaunayCheck3d, AsksNothingOfConstrainedFaces)
{
    TetReplacement3d replacement(mesh());
    for (const TetId tet : finiteTets(mesh())) {
        for (int i = 0; i < 4; ++i) {
            const std::optional<Flip3d> flip = evaluateFlip23(mesh(), {tet, i});
            if (!flip) continue;
            applyFlip(replacement, *flip);
            for (const TetId made : replacement.created()) {
                for (int face = 0; face < 4; ++face) mesh().setFaceConstrained({made, face}, true);
            }
            EXPECT_TRUE(isDelaunay(mesh(), DelaunayScope::Local));
            return;
        }
    }
}

}  // namespace
}  // namespace mesher::test
