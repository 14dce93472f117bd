#include "base/random.h"
#include "brep/analytic/solids.h"
#include "improvement/dihedral_score.h"
#include "improvement/edge_contraction.h"
#include "improvement/edge_removal.h"
#include "improvement/face_removal.h"
#include "improvement/vertex_insertion.h"
#include "improvement/vertex_smoothing.h"
#include "unit/improvement/small_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mesher {
namespace {

using test::ringAroundEdge;
using test::SmallMesh;

/// A mesh with all that the operations need.
struct Workshop
{
    SmallMesh small;
    TetComplex complex;
    BoundaryGeometry geometry;
    LocalChange change;

    explicit Workshop(SmallMesh made)
        : small(std::move(made)), complex(small.mesh), geometry(small.model, complex, small.mesh.nodes, 0.0)
    {
    }

    void applyAndCheck()
    {
        const double volume = test::volumeOf(complex);
        const double score = test::leastScore(complex);
        apply(change, complex, geometry);
        EXPECT_NEAR(test::volumeOf(complex), volume, 1e-12 * volume);
        EXPECT_GT(test::leastScore(complex), score);
        EXPECT_DOUBLE_EQ(test::leastScore(complex), change.score);
    }
};

/// The best least score over all triangulations of the nodes i to j, by trying all.
double bestByTrying(const TetComplex& complex, const std::vector<NodeId>& ring, std::size_t i, std::size_t j)
{
    if (j - i < 2) return 1.0;
    double best = 0.0;
    for (std::size_t k = i + 1; k < j; ++k) {
        const double above = dihedralScore(complex.corners({ring[i], ring[k], ring[j], NodeId(1)}));
        const double below = dihedralScore(complex.corners({ring[k], ring[i], ring[j], NodeId(0)}));
        best = std::max(best, std::min({above, below, bestByTrying(complex, ring, i, k),
                                        bestByTrying(complex, ring, k, j)}));
    }
    return best;
}

TEST(EdgeRemoval, FindsTheBestOfAllTriangulations)
{
    for (std::uint32_t n = 3; n <= kMostAroundEdge; ++n) {
        SCOPED_TRACE(n);
        Workshop shop(ringAroundEdge(n, 1.6, 0.08));
        std::vector<NodeId> ring;
        for (std::uint32_t i = 0; i < n; ++i) ring.push_back(NodeId(2 + i));
        const double best = bestByTrying(shop.complex, ring, 0, n - 1);
        const bool isBetter = best > leastBetter(test::leastScore(shop.complex));
        ASSERT_EQ(evaluateEdgeRemoval(shop.complex, shop.geometry, NodeId(0), NodeId(1), {}, shop.change),
                  isBetter);
        if (!isBetter) continue;
        EXPECT_DOUBLE_EQ(shop.change.score, best);
        EXPECT_EQ(shop.change.added[0].size(), 2 * n - 4);
        shop.applyAndCheck();
    }
}

TEST(EdgeRemoval, HelpsALongEdgeAndLeavesAShortOne)
{
    Workshop spindle(ringAroundEdge(5, 3.0, 0.0));
    EXPECT_FALSE(evaluateEdgeRemoval(spindle.complex, spindle.geometry, NodeId(0), NodeId(1),
                                     {BoundaryChanges::Allowed, 0.9}, spindle.change));
    Workshop flat(ringAroundEdge(4, 1.0, 0.0));
    EXPECT_FALSE(evaluateEdgeRemoval(flat.complex, flat.geometry, NodeId(0), NodeId(1), {}, flat.change));
    Workshop longer(ringAroundEdge(3, 2.0, 0.0));
    EXPECT_TRUE(
        evaluateEdgeRemoval(longer.complex, longer.geometry, NodeId(0), NodeId(1), {}, longer.change));
    EXPECT_EQ(longer.change.added[0].size(), 2u);
}

TEST(EdgeRemoval, LeavesEdgesWithoutACompleteRing)
{
    SmallMesh open = ringAroundEdge(5, 2.0, 0.0);
    open.mesh.tets.pop_back();
    Workshop shop(std::move(open));
    EXPECT_FALSE(evaluateEdgeRemoval(shop.complex, shop.geometry, NodeId(0), NodeId(1), {}, shop.change));
    Workshop crowd(ringAroundEdge(kMostAroundEdge + 1, 2.0, 0.0));
    EXPECT_FALSE(evaluateEdgeRemoval(crowd.complex, crowd.geometry, NodeId(0), NodeId(1), {}, crowd.change));
}

/// A flat tetrahedron on the plane z = 0 with two triangles of that face below, and others above if it is all there is.
SmallMesh blister(bool isAllThereIs)
{
    SmallMesh small;
    small.model = makeBox({-5, -5, 0}, {5, 5, 5}).value();
    const NodeId a = small.add({-1, 0, 0.0});
    const NodeId b = small.add({1, 0, 0.0});
    const NodeId left = small.add({0, -1, 0.01});
    const NodeId right = small.add({0, 1, 0.01});
    small.addTet(a, b, left, right);
    constexpr std::uint32_t kBottom = 4;
    small.mesh.triangles.push_back({{a, left, b}, {2, kBottom}});
    small.mesh.triangles.push_back({{b, right, a}, {2, kBottom}});
    if (isAllThereIs) small.mesh.triangles.push_back({{left, right, a}, {2, kBottom}});
    return small;
}

TEST(EdgeRemoval, TakesOffAFlatTetrahedronUnlessItIsAllThereIs)
{
    Workshop shop(blister(false));
    ASSERT_TRUE(evaluateEdgeRemoval(shop.complex, shop.geometry, NodeId(0), NodeId(1), {}, shop.change));
    EXPECT_TRUE(shop.change.added[0].empty() && shop.change.added[1].empty());
    EXPECT_TRUE(shop.change.swapsFacets);
    apply(shop.change, shop.complex, shop.geometry);
    EXPECT_EQ(test::tetCount(shop.complex), 0u);
    EXPECT_TRUE(shop.complex.isOnSurface(NodeId(2), NodeId(3)));
    EXPECT_FALSE(shop.complex.isOnSurface(NodeId(0), NodeId(1)));
    Workshop whole(blister(true));
    EXPECT_FALSE(evaluateEdgeRemoval(whole.complex, whole.geometry, NodeId(0), NodeId(1), {}, whole.change));
}

/// A fan of triangles in the plane, each with a tetrahedron above and below: the reverse of edge removal.
SmallMesh sandwich(std::uint32_t n, double height)
{
    SmallMesh small = ringAroundEdge(n, height, 0.0);
    small.mesh.tets.clear();
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
        const NodeId p(2), q(2 + i), r(3 + i);
        small.addTet(p, q, r, NodeId(1));
        small.addTet(q, p, r, NodeId(0));
    }
    return small;
}

TEST(FaceRemoval, TakesAllFacesBetweenTwoNodes)
{
    for (std::uint32_t n = 3; n <= 7; ++n) {
        SCOPED_TRACE(n);
        Workshop shop(sandwich(n, 0.45));
        ASSERT_TRUE(evaluateFaceRemoval(shop.complex, TetId(0), 3, 0.0, shop.change));
        EXPECT_EQ(shop.change.removed[0].size(), 2 * (n - 2));
        EXPECT_EQ(shop.change.added[0].size(), n);
        shop.applyAndCheck();
    }
}

TEST(FaceRemoval, LeavesGoodTetrahedraAndFacesWithNothingBehind)
{
    Workshop good(sandwich(3, 1.4));
    EXPECT_FALSE(evaluateFaceRemoval(good.complex, TetId(0), 3, 0.0, good.change));
    Workshop flat(sandwich(4, 0.45));
    EXPECT_FALSE(evaluateFaceRemoval(flat.complex, TetId(0), 3, 0.9, flat.change));
    for (std::size_t i = 0; i < 3; ++i) {
        const FacetNodes face = flat.complex.faceOf(TetId(0), i);
        const bool hasOther = flat.complex.tetBeside(face[0], face[1], face[2], TetId(0)).isValid();
        if (!hasOther) {
            EXPECT_FALSE(evaluateFaceRemoval(flat.complex, TetId(0), i, 0.0, flat.change));
        }
    }
}

/// A sandwich of two solids with the first face between them, which is a face of the model.
SmallMesh dividedSandwich(double height)
{
    SmallMesh small = sandwich(3, height);
    small.mesh.tets[1].entity.index = 1;
    small.mesh.triangles.push_back({{NodeId(2), NodeId(3), NodeId(4)}, {2, 0}});
    return small;
}

TEST(FaceRemoval, LeavesFacesBetweenSolids)
{
    Workshop shop(dividedSandwich(0.45));
    EXPECT_FALSE(evaluateFaceRemoval(shop.complex, TetId(0), 3, 0.0, shop.change));
}

/// An octahedron with a node inside.
SmallMesh octahedron(const Vec3& inside)
{
    SmallMesh small;
    const NodeId centre = small.add(inside);
    const Vec3 tips[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const Vec3& p : tips) small.add(p);
    for (std::uint32_t x = 1; x <= 2; ++x) {
        for (std::uint32_t y = 3; y <= 4; ++y) {
            for (std::uint32_t z = 5; z <= 6; ++z) {
                const bool isTurned = (x + y + z) % 2 == 0;
                small.addTet(NodeId(isTurned ? y : x), NodeId(isTurned ? x : y), NodeId(z), centre);
            }
        }
    }
    for (auto& tet : small.mesh.tets) {
        TetCorners p;
        for (std::size_t k = 0; k < 4; ++k) p[k] = small.mesh.nodes[tet.node[k]].position;
        if (sixfoldVolume(p) < 0.0) std::swap(tet.node[0], tet.node[1]);
    }
    return small;
}

TEST(VertexSmoothing, BringsANodeToTheMiddle)
{
    Workshop shop(octahedron({0.4, -0.3, 0.25}));
    VertexSmoothing smoothing(shop.complex, shop.geometry, BoundaryChanges::Allowed);
    const double before = test::leastScore(shop.complex);
    double score = before;
    for (int i = 0; i < 6 && smoothing.evaluate(NodeId(0), 1.0); ++i) {
        EXPECT_GT(smoothing.score(), score);
        score = smoothing.score();
        shop.complex.move(NodeId(0), smoothing.move().position, {});
        EXPECT_DOUBLE_EQ(test::leastScore(shop.complex), score);
    }
    EXPECT_GT(score, 1.5 * before);
    EXPECT_LT(length(shop.complex.position(NodeId(0))), 0.15);
}

TEST(VertexSmoothing, EndsAtTheTargetAndWhereThereIsNoWayUp)
{
    Workshop shop(octahedron({0.4, -0.3, 0.25}));
    VertexSmoothing smoothing(shop.complex, shop.geometry, BoundaryChanges::Allowed);
    EXPECT_FALSE(smoothing.evaluate(NodeId(0), 0.9 * test::leastScore(shop.complex)));
    Workshop best(octahedron({0, 0, 0}));
    VertexSmoothing there(best.complex, best.geometry, BoundaryChanges::Allowed);
    EXPECT_FALSE(there.evaluate(NodeId(0), 1.0));
}

TEST(VertexSmoothing, LeavesNodesOfTheBoundaryThatAreOnNoEntityOfIt)
{
    SmallMesh small = octahedron({0.4, -0.3, 0.25});
    small.mesh.triangles.push_back({{NodeId(0), NodeId(1), NodeId(3)}, {2, 0}});
    Workshop shop(std::move(small));
    VertexSmoothing smoothing(shop.complex, shop.geometry, BoundaryChanges::Allowed);
    EXPECT_FALSE(smoothing.evaluate(NodeId(0), 1.0));
    EXPECT_FALSE(evaluateContraction(shop.complex, NodeId(0), shop.change));
}

TEST(EdgeContraction, DrawsANodeIntoOneThatIsTooNear)
{
    Workshop shop(octahedron({0.9, 0.03, 0.02}));
    ASSERT_TRUE(evaluateContraction(shop.complex, NodeId(0), shop.change));
    EXPECT_EQ(shop.change.gone, std::vector<NodeId>(1, NodeId(0)));
    EXPECT_EQ(shop.change.removed[0].size(), 8u);
    EXPECT_EQ(shop.change.added[0].size(), 4u);
    shop.applyAndCheck();
    ClassifiedMesh mesh = shop.small.mesh;
    shop.complex.writeTo(mesh);
    EXPECT_EQ(mesh.nodes.size(), 6u);
    EXPECT_EQ(mesh.tets.size(), 4u);
}

TEST(EdgeContraction, LeavesANodeInTheMiddle)
{
    Workshop shop(octahedron({0, 0, 0}));
    EXPECT_FALSE(evaluateContraction(shop.complex, NodeId(0), shop.change));
}

TEST(VertexInsertion, HalvesALongEdge)
{
    Workshop shop(ringAroundEdge(5, 3.0, 0.0));
    VertexSmoothing smoothing(shop.complex, shop.geometry, BoundaryChanges::Allowed);
    VertexInsertion insertion(shop.complex, smoothing);
    ASSERT_TRUE(insertion.evaluate(TetId(0), 0.0, 0.9, shop.change));
    EXPECT_EQ(shop.change.added[0].size(), shop.change.removed[0].size() * 2);
    const std::uint32_t nodes = shop.complex.nodeLimit();
    shop.applyAndCheck();
    EXPECT_EQ(shop.complex.nodeLimit(), nodes + 1);
    EXPECT_EQ(shop.complex.node(NodeId(nodes)).entity, (EntityRef{3, 0}));
}

TEST(VertexInsertion, TakesOutANodeThatItsCavityEncloses)
{
    SmallMesh small;
    const NodeId a = small.add({1, 1, 1});
    const NodeId b = small.add({1, -1, -1});
    const NodeId c = small.add({-1, -1, 1});
    const NodeId d = small.add({-1, 1, -1});
    const NodeId inside = small.add({0.6, 0.6, 0.5});
    small.addTet(inside, b, c, d);
    small.addTet(a, inside, c, d);
    small.addTet(a, b, inside, d);
    small.addTet(a, b, c, inside);
    Workshop shop(std::move(small));
    ASSERT_GT(test::leastScore(shop.complex), 0.0);
    VertexSmoothing smoothing(shop.complex, shop.geometry, BoundaryChanges::Allowed);
    ASSERT_TRUE(VertexInsertion(shop.complex, smoothing).evaluate(TetId(0), 0.0, 0.9, shop.change));
    EXPECT_EQ(shop.change.gone, std::vector<NodeId>(1, inside));
    shop.applyAndCheck();
    ClassifiedMesh mesh = shop.small.mesh;
    shop.complex.writeTo(mesh);
    EXPECT_EQ(mesh.nodes.size(), 5u);
    EXPECT_EQ(mesh.tets.size(), 4u);
}

TEST(VertexInsertion, KeepsFacesBetweenSolids)
{
    Random random(5);
    int helped = 0;
    for (int i = 0; i < 2000; ++i) {
        SmallMesh small = dividedSandwich(0.5);
        for (std::uint32_t n = 0; n < 5; ++n) {
            Vec3& p = small.mesh.nodes[NodeId(n)].position;
            p = p + Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-0.4, 0.4)};
        }
        Workshop divided(small);
        if (test::leastScore(divided.complex) <= 0.0) continue;
        VertexSmoothing smoothing(divided.complex, divided.geometry, BoundaryChanges::Allowed);
        EXPECT_FALSE(
            VertexInsertion(divided.complex, smoothing).evaluate(TetId(0), 0.0, 0.9, divided.change));
        small.mesh.triangles.clear();
        small.mesh.tets[1].entity.index = 0;
        Workshop whole(small);
        VertexSmoothing free(whole.complex, whole.geometry, BoundaryChanges::Allowed);
        helped += VertexInsertion(whole.complex, free).evaluate(TetId(0), 0.0, 0.9, whole.change) ? 1 : 0;
    }
    EXPECT_GT(helped, 5);
}

TEST(VertexInsertion, LeavesWhatItDoesNotHelp)
{
    Workshop shop(octahedron({0, 0, 0}));
    VertexSmoothing smoothing(shop.complex, shop.geometry, BoundaryChanges::Allowed);
    VertexInsertion insertion(shop.complex, smoothing);
    EXPECT_FALSE(insertion.evaluate(TetId(0), 0.0, 1.0, shop.change));
    EXPECT_EQ(test::tetCount(shop.complex), 8u);
}

}  // namespace
}  // namespace mesher
