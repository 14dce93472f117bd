#include "pipeline/left_elements.h"

#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace mesher {
namespace {

constexpr std::uint64_t kNoLimit = 50'000'000;

MeshOutcome meshPlate(std::optional<std::uint64_t> maxWallElements, double thickness = 0.04,
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

TEST(LeftElements, TellTheRimsOfAWallThatIsKeptFlatWithIt)
{
    const MeshOutcome outcome = meshPlate(100'000, 0.001);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Done);
    ASSERT_TRUE(outcome.mesh.has_value());
    EXPECT_LT(outcome.mesh->tets.size(), 5000u);
    ASSERT_EQ(outcome.report.warnings.size(), 1u);
    const std::string& warning = outcome.report.warnings.front();
    EXPECT_NE(warning.find("the wall between Face5 and Face6"), std::string::npos) << warning;
    EXPECT_NE(warning.find("flat triangles on its rims Face1, Face2, Face3, Face4"), std::string::npos)
        << warning;
}

/// The sizes ask for a few hundred tetrahedra, good ones would be 46,000.
TEST(LeftElements, KeepWallsFlatByDefaultThatTakeFarMoreThanTheSizesAskFor)
{
    const MeshOutcome outcome = meshPlate(std::nullopt);
    ASSERT_TRUE(outcome.mesh.has_value());
    EXPECT_LT(outcome.mesh->tets.size(), 3000u);
    ASSERT_EQ(outcome.report.warnings.size(), 1u);
    const std::string& warning = outcome.report.warnings.front();
    const std::string option = "--max-wall-elements ";
    const std::size_t at = warning.find(option);
    ASSERT_NE(at, std::string::npos) << warning;
    // What the warning proposes is enough.
    const MeshOutcome good = meshPlate(std::stoull(warning.substr(at + option.size())));
    EXPECT_TRUE(good.report.warnings.empty());
    ASSERT_TRUE(good.report.tetQuality.has_value());
    EXPECT_GE(good.report.tetQuality->dihedral.least(), 18.0);
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
    SurfaceMesh mesh;
    for (const std::uint32_t face : {3u, 1u, 3u, 2u}) {
        SurfaceFacet facet;
        facet.face = BrepFaceId(face);
        facet.node = {NodeId(0), NodeId(1), NodeId(2)};
        mesh.facets.push_back(facet);
    }
    MeshReport report;
    report.failures.push_back({ErrorCode::OutOfRange, "the limit of 3 elements is reached", "model", {}, ""});
    nameFaceOverLimit(mesh, report);
    EXPECT_EQ(report.failures.front().entity, "Face4");
    EXPECT_NE(report.failures.front().message.find("triangles on the faces alone"), std::string::npos);
}

}  // namespace
}  // namespace mesher
