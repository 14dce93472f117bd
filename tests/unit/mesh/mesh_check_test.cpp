#include "mesh/mesh_check.h"

#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace mesher {
namespace {

std::string joined(const std::vector<std::string>& clauses)
{
    std::string text;
    for (const std::string& clause : clauses) text += clause + "; ";
    return text;
}

TEST(MeshCheck, FindsNothingInAValidPlaneMesh)
{
    const MeshCheckReport report = checkMesh(test::twoFaceMesh());
    EXPECT_TRUE(report.isValid()) << joined(report.problems());
    EXPECT_NEAR(report.area, 0.8 * 0.4, 1e-14);
    ASSERT_EQ(report.areaOfFace.size(), 2u);
    EXPECT_NEAR(report.areaOfFace.at(1), 0.16, 1e-14);
}

TEST(MeshCheck, FindsNothingInAValidVolumeMesh)
{
    const MeshCheckReport report = checkMesh(test::twoSolidMesh());
    EXPECT_TRUE(report.isValid()) << joined(report.problems());
    EXPECT_NEAR(report.volume, 0.4 * 0.2 * 0.2, 1e-15);
    ASSERT_EQ(report.volumeOfSolid.size(), 2u);
    EXPECT_NEAR(report.volumeOfSolid.at(0), 0.008, 1e-15);
}

TEST(MeshCheck, RefusesAnEmptyMesh) { EXPECT_FALSE(checkMesh({}).isValid()); }

TEST(MeshCheck, FindsAMissingAndARepeatedNode)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.triangles[0].node[0] = NodeId(100000);
    mesh.triangles[1].node[0] = mesh.triangles[1].node[1];
    EXPECT_EQ(checkMesh(mesh).badReferences, 2u);
}

TEST(MeshCheck, FindsCoordinatesThatCannotBeComputedWith)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.nodes[NodeId(0)].position.x = std::numeric_limits<double>::quiet_NaN();
    mesh.nodes[NodeId(1)].position.y = 1e301;
    EXPECT_EQ(checkMesh(mesh).nonFiniteNodes, 2u);
}

TEST(MeshCheck, FindsDuplicateAndOrphanNodes)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.nodes.push_back(mesh.nodes[NodeId(0)]);
    const MeshCheckReport report = checkMesh(mesh);
    EXPECT_EQ(report.duplicateNodes, 1u);
    EXPECT_EQ(report.orphanNodes, 1u);
}

TEST(MeshCheck, PartsThatTouchHaveNodesOfTheirOwn)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    const auto count = static_cast<std::uint32_t>(mesh.nodes.size());
    const ClassifiedMesh once = mesh;
    for (const MeshNode& node : once.nodes) mesh.nodes.push_back(node);
    for (MeshElement<3> triangle : once.triangles) {
        for (NodeId& node : triangle.node) node = NodeId(node.value + count);
        mesh.triangles.push_back(triangle);
    }
    EXPECT_EQ(checkMesh(mesh).duplicateNodes, 0u);
    mesh.triangles.push_back({{NodeId(0), NodeId(1), NodeId(count + 2)}, {2, 0}});
    EXPECT_EQ(checkMesh(mesh).duplicateNodes, count);
}

TEST(MeshCheck, FindsDuplicateElements)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.lines.push_back(mesh.lines[0]);
    EXPECT_EQ(checkMesh(mesh).duplicateElements, 1u);
}

TEST(MeshCheck, FindsWrongAndMissingClassification)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.lines[0].entity = {2, 0};
    mesh.triangles[0].entity.index = EntityRef::kNone;
    EXPECT_EQ(checkMesh(mesh).misclassified, 1u);
    EXPECT_EQ(checkMesh(mesh).unclassified, 1u);
    mesh = test::twoFaceMesh();
    for (MeshNode& node : mesh.nodes) {
        if (node.entity == EntityRef{2, 0}) node.entity.index = 1;  // inside of the other face
    }
    EXPECT_GT(checkMesh(mesh).misclassified, 0u);
}

TEST(MeshCheck, FindsMissingLines)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.lines.clear();
    const MeshCheckReport report = checkMesh(mesh);
    EXPECT_EQ(report.boundaryWithoutElement, 24u);
    EXPECT_EQ(report.interfaceWithoutElement, 4u);
}

TEST(MeshCheck, FindsALineThatIsNoEdge)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.lines.push_back({{NodeId(0), NodeId(17)}, mesh.lines[0].entity});
    EXPECT_EQ(checkMesh(mesh).linesNotEdges, 1u);
}

TEST(MeshCheck, FindsATurnedTriangle)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    std::swap(mesh.triangles[5].node[0], mesh.triangles[5].node[1]);
    const MeshCheckReport report = checkMesh(mesh);
    EXPECT_EQ(report.inverted, 1u);
    EXPECT_GT(report.foldedSides, 0u);
}

TEST(MeshCheck, FindsAFlatTriangleByAnExactTest)
{
    // A triangle whose area is less than a rounding error of the formula in doubles, and an exactly flat one.
    ClassifiedMesh mesh;
    for (const Vec3& p :
         {Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 1.0, 0.0}, Vec3{3.0, 3.0, 0.0}, Vec3{0.0, 1.0, 0.0}}) {
        mesh.nodes.push_back({p, {2, 0}, {}});
    }
    mesh.triangles.push_back({{NodeId(0), NodeId(2), NodeId(3)}, {2, 0}});
    mesh.triangles.push_back({{NodeId(0), NodeId(1), NodeId(2)}, {2, 0}});
    EXPECT_EQ(checkMesh(mesh).degenerate, 1u);
}

TEST(MeshCheck, FindsAnEdgeOfThreeTrianglesOfOneFace)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    MeshElement<3> extra = mesh.triangles[0];
    extra.node[1] = NodeId(20);  // the diagonal from node 0 to 2 is inside
    mesh.triangles.push_back(extra);
    EXPECT_GT(checkMesh(mesh).overSharedSides, 0u);
}

TEST(MeshCheck, FindsAnInvertedTet)
{
    ClassifiedMesh mesh = test::twoSolidMesh();
    std::swap(mesh.tets[7].node[0], mesh.tets[7].node[1]);
    const MeshCheckReport report = checkMesh(mesh);
    EXPECT_EQ(report.inverted, 1u);
    EXPECT_EQ(report.foldedSides, 0u);  // it lies where it should, only its numbering is turned
}

TEST(MeshCheck, FindsAMissingTet)
{
    ClassifiedMesh mesh = test::twoSolidMesh();
    mesh.tets.erase(mesh.tets.begin() + 7);
    EXPECT_GT(checkMesh(mesh).boundaryWithoutElement, 0u);
}

TEST(MeshCheck, FindsAVertexPulledThroughTheOppositeFace)
{
    ClassifiedMesh mesh = test::twoSolidMesh(3);
    for (MeshNode& node : mesh.nodes) {
        if (node.entity == EntityRef{3, 0}) {
            node.position.x += 0.35;
            break;
        }
    }
    const MeshCheckReport report = checkMesh(mesh);
    EXPECT_GT(report.inverted, 0u);
    EXPECT_GT(report.foldedSides, 0u);
}

TEST(MeshCheck, FindsAFaceOfThreeTets)
{
    ClassifiedMesh mesh = test::twoSolidMesh();
    MeshElement<4> extra = mesh.tets[0];
    extra.node[3] = NodeId(static_cast<std::uint32_t>(mesh.nodes.size() - 1));
    mesh.tets.push_back(extra);
    EXPECT_GT(checkMesh(mesh).overSharedSides + checkMesh(mesh).foldedSides, 0u);
}

TEST(MeshCheck, FindsMissingInwardAndStrayTriangles)
{
    ClassifiedMesh mesh = test::twoSolidMesh();
    const std::size_t count = mesh.triangles.size();
    std::swap(mesh.triangles[0].node[0], mesh.triangles[0].node[1]);
    EXPECT_EQ(checkMesh(mesh).inwardTriangles, 1u);
    mesh = test::twoSolidMesh();
    mesh.triangles.clear();
    const MeshCheckReport report = checkMesh(mesh);
    EXPECT_EQ(report.boundaryWithoutElement + report.interfaceWithoutElement, count);
    EXPECT_EQ(report.interfaceWithoutElement, 8u);
    mesh = test::twoSolidMesh();
    mesh.triangles.push_back({{NodeId(0), NodeId(7), NodeId(22)}, {2, 0}});
    EXPECT_EQ(checkMesh(mesh).trianglesNotFaces, 1u);
}

}  // namespace
}  // namespace mesher
