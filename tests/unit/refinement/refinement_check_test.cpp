#include "refinement/refinement_check.h"

#include "unit/refinement/refinement_fixture.h"

namespace mesher::test {
namespace {

bool isFlagged(const SampledSolid& solid, const std::string& problem)
{
    return checkRefinement(solid.tetrahedralization, solid.splitter->mesh()).problem.find(problem) !=
           std::string::npos;
}

TetFace anyFacet(const SampledSolid& solid)
{
    const auto& node = solid.splitter->mesh().facets[FacetId(0u)].node;
    const ConstrainedTetrahedralization& t = solid.tetrahedralization;
    return t.mesh().findFace(t.vertexOf[node[0]], t.vertexOf[node[1]], t.vertexOf[node[2]]);
}

TEST(RefinementCheck, AcceptsSampledSolids)
{
    EXPECT_TRUE(isSound(sampledBox({1, 1, 1}, 3)));
    EXPECT_TRUE(isSound(sampledTorus(2.0, 1.0, 20)));
}

TEST(RefinementCheck, SeesALostFacet)
{
    SampledSolid solid = sampledBox({1, 1, 1}, 2);
    solid.tetrahedralization.mesh().setFaceConstrained(anyFacet(solid), false);
    EXPECT_TRUE(isFlagged(solid, "constrained faces for"));
}

TEST(RefinementCheck, SeesAConstraintThatIsNoFacet)
{
    SampledSolid solid = sampledBox({1, 1, 1}, 2);
    Triangulation3d& mesh = solid.tetrahedralization.mesh();
    const TetId tet = anyFacet(solid).tet();
    for (int face = 0; face < 4; ++face) mesh.setFaceConstrained({tet, face}, true);
    EXPECT_TRUE(isFlagged(solid, "a constrained face is no facet"));
}

TEST(RefinementCheck, SeesALostSegment)
{
    SampledSolid solid = sampledBox({1, 1, 1}, 2);
    ConstrainedTetrahedralization& t = solid.tetrahedralization;
    const auto& node = solid.splitter->mesh().segments[SegmentId(0u)].node;
    const VertexId a = t.vertexOf[node[0]];
    const VertexId b = t.vertexOf[node[1]];
    t.mesh().setEdgeConstrained(t.mesh().findEdge(a, b), a, b, false);
    EXPECT_TRUE(isFlagged(solid, "constrained edges for"));
}

TEST(RefinementCheck, SeesMapsThatDisagree)
{
    SampledSolid facet = sampledBox({1, 1, 1}, 2);
    facet.tetrahedralization.facetOf.erase((*facet.tetrahedralization.facetOf.begin()).key);
    EXPECT_TRUE(isFlagged(facet, "is not in the map"));
    SampledSolid segment = sampledBox({1, 1, 1}, 2);
    segment.tetrahedralization.segmentOf.erase((*segment.tetrahedralization.segmentOf.begin()).key);
    EXPECT_TRUE(isFlagged(segment, "is not in the map"));
    SampledSolid node = sampledBox({1, 1, 1}, 2);
    std::swap(node.tetrahedralization.vertexOf[NodeId(0u)], node.tetrahedralization.vertexOf[NodeId(1u)]);
    EXPECT_TRUE(isFlagged(node, "without a vertex of its own"));
}

TEST(RefinementCheck, SeesAMovedVertexAndARegionThatLeaks)
{
    SampledSolid moved = sampledBox({1, 1, 1}, 2);
    moved.tetrahedralization.mesh().setPosition(VertexId(0u), {-0.01, 0, 0});
    EXPECT_TRUE(isFlagged(moved, "elsewhere"));
    SampledSolid leaking = sampledBox({1, 1, 1}, 2);
    leaking.tetrahedralization.mesh().setRegion(meshedTets(leaking).front(), RegionId(2u));
    EXPECT_TRUE(isFlagged(leaking, "separates two regions"));
}

}  // namespace
}  // namespace mesher::test
