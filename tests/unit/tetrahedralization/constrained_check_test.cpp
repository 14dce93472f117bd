#include "delaunay/constrained_check.h"

#include "support/sample_surfaces.h"
#include "tetrahedralization/tetrahedralize.h"

#include <gtest/gtest.h>

namespace mesher {
namespace {

class ConstrainedCheck : public ::testing::Test
{
protected:
    void SetUp() override
    {
        sample_ = test::flippedBoxSurface(3, 0, {1.0, 2.0, 3.0}, 1);
        auto result = tetrahedralize(sample_.mesh, sample_.sides, {}, context_);
        ASSERT_TRUE(result);
        tets_ = std::move(result->tets);
        ASSERT_TRUE(checkConstraints(tets_, sample_.mesh).isValid());
        ASSERT_TRUE(checkRegions(tets_, sample_.mesh, sample_.sides).isValid());
    }

    [[nodiscard]] std::array<VertexId, 3> cornersOf(FacetId facet) const
    {
        const auto& node = sample_.mesh.facets[facet].node;
        return {tets_.vertexOf[node[0]], tets_.vertexOf[node[1]], tets_.vertexOf[node[2]]};
    }

    RunContext context_;
    test::SampleSurface sample_;
    ConstrainedTetrahedralization tets_;
};

TEST_F(ConstrainedCheck, findsAFacetWithoutItsConstraint)
{
    const auto [a, b, c] = cornersOf(FacetId(5u));
    tets_.mesh().setFaceConstrained(tets_.mesh().findFace(a, b, c), false);
    EXPECT_EQ(checkConstraints(tets_, sample_.mesh).violations, 1u);
}

TEST_F(ConstrainedCheck, findsASegmentWithoutItsConstraint)
{
    const auto& node = sample_.mesh.segments[SegmentId(0u)].node;
    const VertexId a = tets_.vertexOf[node[0]];
    const VertexId b = tets_.vertexOf[node[1]];
    tets_.mesh().setEdgeConstrained(tets_.mesh().findEdge(a, b), a, b, false);
    EXPECT_EQ(checkConstraints(tets_, sample_.mesh).violations, 1u);
}

TEST_F(ConstrainedCheck, findsConstraintsThatAreNone)
{
    // A face inside of the solid: next to a facet, but not one.
    const auto [a, b, c] = cornersOf(FacetId(5u));
    TetFace face = tets_.mesh().findFace(a, b, c);
    if (tets_.mesh().region(face.tet()) == kExteriorRegion) face = tets_.mesh().neighbour(face);
    TetFace inner(face.tet(), (face.face() + 1) % 4);
    while (tets_.mesh().isFaceConstrained(inner)) inner = TetFace(inner.tet(), (inner.face() + 1) % 4);
    tets_.mesh().setFaceConstrained(inner, true);
    EXPECT_GE(checkConstraints(tets_, sample_.mesh).violations, 2u) << "once from either side";
}

TEST_F(ConstrainedCheck, findsAFacetThatIsMissing)
{
    sample_.mesh.facets.push_back(sample_.mesh.facets[FacetId(0u)]);
    auto& added = sample_.mesh.facets[FacetId(static_cast<std::uint32_t>(sample_.mesh.facets.size() - 1))];
    added.node = {NodeId(0u), NodeId(7u), NodeId(30u)};
    EXPECT_FALSE(checkConstraints(tets_, sample_.mesh).isValid());
}

TEST_F(ConstrainedCheck, findsANodeThatMoved)
{
    sample_.mesh.nodes[NodeId(3u)].position.x += 0x1p-40;
    EXPECT_EQ(checkConstraints(tets_, sample_.mesh).violations, 1u);
}

TEST_F(ConstrainedCheck, findsAWrongRegionByFacetAndByVolume)
{
    const auto [a, b, c] = cornersOf(FacetId(5u));
    TetFace face = tets_.mesh().findFace(a, b, c);
    if (tets_.mesh().region(face.tet()) == kExteriorRegion) face = tets_.mesh().neighbour(face);
    tets_.mesh().setRegion(face.tet(), kExteriorRegion);
    EXPECT_GE(checkRegions(tets_, sample_.mesh, sample_.sides).violations, 2u);
}

TEST_F(ConstrainedCheck, countsFacesThatAreNotDelaunay)
{
    EXPECT_EQ(countNonDelaunayFaces(tets_.mesh(), DelaunayPart::Inside), 0u);
    // A vertex pushed towards its neighbour spoils the property somewhere.
    Triangulation3d& mesh = tets_.mesh();
    const VertexId v = tets_.vertexOf[NodeId(0u)];
    mesh.setPosition(v, 0.4 * mesh.position(v) + 0.6 * mesh.position(tets_.vertexOf[NodeId(20u)]));
    EXPECT_GT(countNonDelaunayFaces(mesh, DelaunayPart::Everywhere), 0u);
}

}  // namespace
}  // namespace mesher
