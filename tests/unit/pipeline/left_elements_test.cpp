#include "pipeline/left_elements.h"

#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mesher {
namespace {

constexpr std::uint64_t kNoLimit = 50'000'000;

MeshOutcome meshPlate(std::uint64_t maxWallElements, double thickness = 0.04,
                      std::uint64_t maxElements = kNoLimit)
{
    const Result<BrepModel> plate = makeBox({0.0, 0.0, 0.0}, {4.0, 4.0, thickness});
    MeshOptions options;
    options.maxElements = maxElements;
    options.size = 0.5;
    options.isImproved = false;
    options.maxWallElements = maxWallElements;
    RunContext context;
    return meshSolids(*plate, options, nullptr, context);
}

TEST(LeftElements, TellAWallThatIsKeptFlat)
{
    const MeshOutcome outcome = meshPlate(20'000);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Done);
    ASSERT_TRUE(outcome.mesh.has_value());
    ASSERT_EQ(outcome.report.warnings.size(), 1u);
    EXPECT_NE(outcome.report.warnings.front().find("the wall between Face5 and Face6, down to 0.04 thick"),
              std::string::npos)
        << outcome.report.warnings.front();
    ASSERT_FALSE(outcome.report.left.empty());
    EXPECT_EQ(outcome.report.left.front().entities, (std::vector<std::string>{"Face5", "Face6"}));
}

TEST(LeftElements, FillAWallWithGoodTetrahedraWhereTheyMayBeAsMany)
{
    const MeshOutcome outcome = meshPlate(1'000'000);
    EXPECT_TRUE(outcome.report.warnings.empty());
    EXPECT_TRUE(outcome.report.left.empty());
    ASSERT_TRUE(outcome.report.tetQuality.has_value());
    EXPECT_GE(outcome.report.tetQuality->dihedral.least(), 18.0);
    EXPECT_LE(outcome.report.tetQuality->dihedral.largest(), 155.1);
}

TEST(LeftElements, NameWhatTheyAreBesideWhereTheShapeAllowsOfNoBetterOnes)
{
    // A hollow that comes to within 0.0015 of the bottom.
    const auto box = makeBox({-3.0, -3.0, 0.0}, {3.0, 3.0, 6.0});
    const auto ball = makeSphere(Axes{.origin = {0.0, 0.0, 2.0015}}, 2.0);
    ASSERT_TRUE(box && ball);
    MeshOptions options;
    options.size = 1.2;
    options.curvature = 12.0;
    options.isImproved = false;
    options.maxWallElements = 100'000'000;
    RunContext context;
    const MeshOutcome outcome = meshSolids(test::withHollow(*box, *ball), options, nullptr, context);
    ASSERT_FALSE(outcome.report.left.empty());
    for (const LeftElements& left : outcome.report.left) {
        ASSERT_FALSE(left.entities.empty()) << left.reason;
        EXPECT_NE(left.reason.find(left.entities.front()), std::string::npos) << left.reason;
        EXPECT_NE(left.reason.find("beside "), std::string::npos) << left.reason;
    }
    EXPECT_EQ(outcome.report.left.front().entities.front(), "Face5");
}

TEST(LeftElements, TellARimThatIsKeptFlatWhereGoodFacetsWouldTakeFarMoreThanTheWall)
{
    const MeshOutcome outcome = meshPlate(100'000, 0.001);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Done);
    ASSERT_TRUE(outcome.mesh.has_value());
    EXPECT_LT(outcome.mesh->tets.size(), 5000u);
    ASSERT_EQ(outcome.report.warnings.size(), 2u);
    EXPECT_NE(outcome.report.warnings.front().find(
                  "the rim of a wall, Face1, Face2, Face3, Face4, down to 0.001 wide, is left with flat"),
              std::string::npos)
        << outcome.report.warnings.front();
    EXPECT_NE(outcome.report.warnings.back().find("the wall between Face5 and Face6"), std::string::npos);
}

TEST(LeftElements, NameTheWallThatTakesMoreThanTheLimitEvenWithFlatOnes)
{
    const MeshOutcome whole = meshPlate(100'000, 0.001);
    const std::uint64_t most = whole.mesh->tets.size() - whole.mesh->tets.size() / 20;
    const MeshOutcome outcome = meshPlate(100'000, 0.001, most);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Failed);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_EQ(outcome.report.failures.front().entity, "Face5 and Face6");
    EXPECT_NE(outcome.report.failures.front().message.find("even with flat ones"), std::string::npos)
        << outcome.report.failures.front().message;
}

TEST(LeftElements, NameTheFaceWhoseTrianglesReachTheLimit)
{
    // Without a size it is the shape that makes more of them than the estimate knows.
    MeshOptions options;
    options.maxElements = 120;
    RunContext context;
    const MeshOutcome outcome = meshSolids(makeBox({}, {4.0, 4.0, 0.04}).value(), options, nullptr, context);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_EQ(outcome.report.failures.front().entity.substr(0, 4), "Face");
}

}  // namespace
}  // namespace mesher
