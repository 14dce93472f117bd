#include "surface_sampling/surface_check.h"

#include "brep/analytic/solids.h"
#include "brep/face_area.h"
#include "surface_sampling/face_topology.h"
#include "unit/surface_sampling/sampled_model.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <utility>

namespace mesher {
namespace {

using test::SampledModel;

class DamagedMesh : public testing::Test
{
protected:
    void SetUp() override
    {
        test::sampleInto(sampled, *makeCylinder(Axes{}, 1.0, 2.0));
        ASSERT_EQ(checkSurfaceMesh(sampled.model, sampled.mesh).problem(), "");
    }
    [[nodiscard]] std::string problem() const
    {
        return checkSurfaceMesh(sampled.model, sampled.mesh).problem();
    }
    [[nodiscard]] SurfaceFacet& facet(std::uint32_t i) { return sampled.mesh.facets[FacetId(i)]; }

    SampledModel sampled;
};

TEST_F(DamagedMesh, MissesAFacet)
{
    facet(2).face = BrepFaceId();
    EXPECT_NE(problem(), "");
}

TEST_F(DamagedMesh, HasAFacetTwice)
{
    sampled.mesh.facets.push_back(SurfaceFacet(facet(2)));
    EXPECT_NE(problem().find("twice in one sense"), std::string::npos) << problem();
}

TEST_F(DamagedMesh, HasATurnedFacet)
{
    std::swap(facet(3).node[0], facet(3).node[1]);
    std::swap(facet(3).parameters[0], facet(3).parameters[1]);
    EXPECT_NE(problem(), "");
    EXPECT_GT(checkSurfaceMesh(sampled.model, sampled.mesh).faces[facet(3).face].worstCornerAngle, 90.0);
}

TEST_F(DamagedMesh, HasANodeOffItsCurve)
{
    MeshNode& node = sampled.mesh.nodes[NodeId(4)];
    ASSERT_EQ(node.entity.dimension, 1);
    node.position = node.position + Vec3{0.0, 0.0, 1e-6};
    EXPECT_NE(problem().find("lies"), std::string::npos) << problem();
}

TEST_F(DamagedMesh, HasWrongParametersInACorner)
{
    facet(0).parameters[1] = facet(0).parameters[1] + Vec2{0.01, 0.0};
    EXPECT_NE(problem().find("off its parameters"), std::string::npos) << problem();
}

TEST_F(DamagedMesh, HasAChainWithAGap)
{
    sampled.mesh.segments[SegmentId(5)].edge = BrepEdgeId();
    EXPECT_NE(problem().find("no chain"), std::string::npos) << problem();
}

TEST_F(DamagedMesh, HasAFaceThatIsTurnedInItsShell)
{
    sampled.model.solids[BrepSolidId(0)].shells[0].faces[1].isReversed = true;
    // The model's own shell is open then, which is no fault of the mesh: nothing can be said of it.
    EXPECT_EQ(problem(), "");
    EXPECT_FALSE(isClosedShell(sampled.model, sampled.model.solids[BrepSolidId(0)].shells[0]));
}

TEST_F(DamagedMesh, HasAFaceThatUsesOtherNodes)
{
    // A copy of a curve's node: the disk is closed in itself, and not joined to the side any more.
    const NodeId copy = sampled.mesh.nodes.push_back(MeshNode(sampled.mesh.nodes[NodeId(3)]));
    for (SurfaceFacet& each : sampled.mesh.facets) {
        if (each.face != BrepFaceId(1)) continue;
        for (NodeId& node : each.node) node = node == NodeId(3) ? copy : node;
    }
    const SurfaceCheck check = checkSurfaceMesh(sampled.model, sampled.mesh);
    EXPECT_FALSE(check.faces[BrepFaceId(1)].report.isValid());
    EXPECT_TRUE(check.faces[BrepFaceId(0)].report.isValid());
    EXPECT_FALSE(check.shells.isValid());
}

TEST(FaceTopology, IsThatOfDisksCylindersSpheresAndTori)
{
    const auto eulerOf = [](const Result<BrepModel>& model, std::uint32_t face) {
        const FaceTopology topology = topologyOf(*model, model->faces[BrepFaceId(face)]);
        EXPECT_EQ(topology.components, 1);
        return topology.eulerCharacteristic.value_or(-100);
    };
    EXPECT_EQ(eulerOf(makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), 0), 1);
    EXPECT_EQ(eulerOf(makeCylinder(Axes{}, 1.0, 1.0), 0), 0);
    EXPECT_EQ(eulerOf(makeCylinder(Axes{}, 1.0, 1.0), 1), 1);
    EXPECT_EQ(eulerOf(makeCone(Axes{}, 1.0, 0.0, 1.0), 0), 1);
    EXPECT_EQ(eulerOf(makeSphere(Axes{}, 1.0), 0), 2);
    EXPECT_EQ(eulerOf(makeTorus(Axes{}, 3.0, 1.0), 0), 0);
}

TEST(FaceArea, IsThatOfRoundFaces)
{
    constexpr double kPi = std::numbers::pi;
    const auto areaOfFace = [](const Result<BrepModel>& model, std::uint32_t face) {
        return areaOf(*model, model->faces[BrepFaceId(face)]);
    };
    EXPECT_NEAR(areaOfFace(makeCylinder(Axes{}, 2.0, 3.0), 0), 12.0 * kPi, 1e-4);
    EXPECT_NEAR(areaOfFace(makeSphere(Axes{}, 2.0), 0), 16.0 * kPi, 1e-4);
    EXPECT_NEAR(areaOfFace(makeTorus(Axes{}, 3.0, 1.0), 0), 12.0 * kPi * kPi, 1e-3);
}

}  // namespace
}  // namespace mesher
