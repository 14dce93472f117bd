#include "pipeline/mesh_solids.h"

#include "brep/analytic/solids.h"
#include "pipeline/model_check.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace mesher::test {
namespace {

/// One solid of both, as CAD programs write a body that touches itself.
BrepModel oneSolidOf(BrepModel first, const BrepModel& second)
{
    BrepModel model = together(std::move(first), second);
    BrepSolid both = model.solids[BrepSolidId(0)];
    both.shells.push_back(model.solids[BrepSolidId(1)].shells.front());
    model.solids.clear();
    model.solids.push_back(both);
    return model;
}

bool isTold(const MeshReport& report, const std::string& text)
{
    return std::any_of(report.warnings.begin(), report.warnings.end(),
                       [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

void expectMeshOfVolume(const BrepModel& model, double volume, const std::string& note)
{
    MeshOptions options;
    options.size = 0.4;
    options.isChecked = true;
    RunContext context;
    const MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    ASSERT_TRUE(outcome.mesh);
    EXPECT_NEAR(outcome.report.meshVolume, volume, 1e-9);
    EXPECT_TRUE(isTold(outcome.report, note));
    const ModelCheckReport check = checkAgainstModel(*outcome.mesh, model);
    EXPECT_TRUE(check.problems().empty()) << check.problems().front();
}

TEST(MeshSolids, MeshesASolidThatTouchesItselfAlongAnEdge)
{
    expectMeshOfVolume(oneSolidOf(*makeBox({}, {1.0, 1.0, 1.0}), *makeBox({1.0, 1.0, 0.0}, {2.0, 2.0, 1.0})),
                       2.0, "Edge");
}

TEST(MeshSolids, MeshesASolidThatTouchesItselfInAVertex)
{
    expectMeshOfVolume(oneSolidOf(*makeBox({}, {1.0, 1.0, 1.0}), *makeBox({1.0, 1.0, 1.0}, {2.0, 2.0, 2.0})),
                       2.0, "Vertex");
}

TEST(ModelCheck, SeesATriangleThatNamesAnotherFace)
{
    const BrepModel model = *makeBox({}, {1.0, 1.0, 1.0});
    MeshOptions options;
    options.size = 0.5;
    RunContext context;
    const MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    ASSERT_TRUE(outcome.mesh);
    EXPECT_TRUE(checkAgainstModel(*outcome.mesh, model).isValid());
    ClassifiedMesh mesh = *outcome.mesh;
    mesh.triangles.front().entity.index = (mesh.triangles.front().entity.index + 1) % 6;
    EXPECT_EQ(checkAgainstModel(mesh, model).trianglesOff, 1u);
}

TEST(ModelCheck, SeesANodeBeyondTheEdgesOfItsFace)
{
    const BrepModel model = *makeCylinder({}, 1.0, 2.0);
    MeshOptions options;
    options.size = 0.5;
    RunContext context;
    const MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    ASSERT_TRUE(outcome.mesh);
    for (const std::uint32_t face : {0u, 1u, 2u}) {
        ClassifiedMesh mesh = *outcome.mesh;
        const auto node = std::find_if(mesh.nodes.begin(), mesh.nodes.end(), [&](const MeshNode& n) {
            return n.entity == EntityRef{2, face};
        });
        ASSERT_NE(node, mesh.nodes.end());
        // Up the wall beyond its rim, or in the plane of an end beyond its circle.
        const Vec3 there =
            face == 0 ? Vec3{node->position.x, node->position.y, 2.25} : Vec3{1.25, 0.0, 2.0 * (face - 1)};
        node->position = there;
        const ModelCheckReport check = checkAgainstModel(mesh, model);
        EXPECT_EQ(check.nodesOff, 1u) << "face " << face;
        EXPECT_NEAR(check.largestDistance[2], 0.25, 1e-9);
    }
}

TEST(MeshSolids, NamesTheFacesWhereASolidCrossesItself)
{
    MeshOptions options;
    options.size = 0.4;
    RunContext context;
    const BrepModel model =
        oneSolidOf(*makeBox({}, {1.0, 1.0, 1.0}), *makeBox({0.5, 0.3, 0.2}, {2.0, 2.0, 2.0}));
    const MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    EXPECT_NE(outcome.report.status, MeshReport::Status::Done);
    EXPECT_TRUE(!outcome.mesh || outcome.mesh->tets.empty()) << "the surfaces alone may be kept";
    ASSERT_FALSE(outcome.report.failures.empty());
    const Error& error = outcome.report.failures.front();
    EXPECT_EQ(error.code, ErrorCode::IntersectingConstraints);
    EXPECT_NE(error.entity.find(" and Face"), std::string::npos) << error.entity;
    EXPECT_TRUE(error.point.has_value());
    EXPECT_FALSE(error.remedy.empty());
}

std::uint64_t countOf(const MeshReport& report, const std::string& name)
{
    for (const auto& [known, count] : report.counts) {
        if (known == name) return count;
    }
    ADD_FAILURE() << "the report has no " << name;
    return 0;
}

TEST(MeshSolids, MeshesTheTipOfASharpConeWellWithoutImprovement)
{
    constexpr double kHalfAngle = 8.0 * std::numbers::pi / 180.0;
    const auto cone = makeCone({}, 5.0, 0.0, 5.0 / std::tan(kHalfAngle));
    ASSERT_TRUE(cone);
    MeshOptions options;
    options.size = 1.9;
    options.curvature = 12.0;
    options.isImproved = false;
    RunContext context;
    const MeshOutcome outcome = meshSolids(*cone, options, nullptr, context);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    ASSERT_TRUE(outcome.mesh && outcome.report.tetQuality);
    // Refined down to the floor the tip has nearly ten times as many tetrahedra, with angles of 2 degrees.
    EXPECT_LT(outcome.mesh->tets.size(), 12'000u);
    EXPECT_GT(outcome.report.tetQuality->dihedral.least(), 12.0);
    EXPECT_LT(outcome.report.tetQuality->dihedral.largest(), 165.0);
    EXPECT_EQ(countOf(outcome.report, "non_delaunay_faces_left"), 0u);
}

/// Cones of radius 3 that a few slivers were left in: on a ring, in front of a fan, at a base with an angle of less than 60 degrees.
TEST(MeshSolids, LeavesNoSliversInConesWithoutImprovement)
{
    struct Case
    {
        double halfAngle, size, curvature;
    };
    std::uint64_t bentSwaps = 0;
    for (const Case& c :
         {Case{44.0, 1.4, 12.0}, Case{32.0, 0.3, 12.0}, Case{22.0, 0.5, 8.0}, Case{46.0, 0.4, 12.0},
          Case{21.0, 0.4, 8.0}, Case{36.0, 1.4, 8.0}, Case{51.0, 0.5, 12.0}, Case{62.0, 0.4, 12.0},
          Case{58.0, 0.7, 12.0}, Case{28.0, 1.4, 12.0}, Case{36.0, 0.5, 8.0}, Case{30.0, 1.4, 8.0},
          Case{22.0, 1.4, 16.0}, Case{20.0, 1.4, 8.0}, Case{12.0, 0.7, 12.0}, Case{34.0, 0.7, 12.0},
          Case{65.0, 1.0, 8.0}, Case{43.0, 0.5, 12.0}}) {
        SCOPED_TRACE(std::to_string(c.halfAngle) + " " + std::to_string(c.size));
        const auto cone = makeCone({}, 3.0, 0.0, 3.0 / std::tan(c.halfAngle * std::numbers::pi / 180.0));
        ASSERT_TRUE(cone);
        MeshOptions options;
        options.size = c.size;
        options.curvature = c.curvature;
        options.isImproved = false;
        RunContext context;
        const MeshOutcome outcome = meshSolids(*cone, options, nullptr, context);
        ASSERT_TRUE(outcome.mesh && outcome.report.tetQuality);
        EXPECT_GT(outcome.report.tetQuality->dihedral.least(), 18.0);
        EXPECT_LT(outcome.report.tetQuality->dihedral.largest(), 155.1);
        EXPECT_EQ(countOf(outcome.report, "non_delaunay_faces_left"), 0u);
        bentSwaps += countOf(outcome.report, "bent_facet_swaps");
    }
    EXPECT_GT(bentSwaps, 0u);
}

TEST(MeshSolids, SaysWhatKeepsFacesFromBeingDelaunay)
{
    const auto cone = makeCone(Axes{.origin = {0.0, 0.0, 1.0}}, 1.0, 0.0, 8.8);
    const auto box = makeBox({-5.0, -5.0, 0.0}, {5.0, 5.0, 10.0});
    ASSERT_TRUE(cone && box);
    MeshOptions options;
    options.size = 1.2;
    options.curvature = 8.0;
    options.isImproved = false;
    RunContext context;
    const MeshOutcome outcome = meshSolids(withHollow(*box, *cone), options, nullptr, context);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    ASSERT_FALSE(outcome.report.nonDelaunay.empty()) << "this model has no such faces any more: take another";
    std::uint64_t count = 0;
    for (const LeftFaces& faces : outcome.report.nonDelaunay) {
        count += faces.count;
        EXPECT_FALSE(faces.remedy.empty());
        EXPECT_LT(length(faces.place - Vec3{0.0, 0.0, 9.8}), 3.0) << "they are at the tip";
        EXPECT_EQ(faces.reason.find("beside ") != std::string::npos, !faces.entities.empty()) << faces.reason;
    }
    EXPECT_EQ(count, countOf(outcome.report, "non_delaunay_faces_left"));
    const bool isSideNamed =
        std::any_of(outcome.report.nonDelaunay.begin(), outcome.report.nonDelaunay.end(), [](const auto& f) {
            return std::find(f.entities.begin(), f.entities.end(), "Face7") != f.entities.end();
        });
    EXPECT_TRUE(isSideNamed);
}

}  // namespace
}  // namespace mesher::test
