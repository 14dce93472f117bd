#include "pipeline/left_elements.h"

#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mesher {
namespace {

MeshOutcome meshPlate(std::uint64_t maxWallElements)
{
    const Result<BrepModel> plate = makeBox({0.0, 0.0, 0.0}, {4.0, 4.0, 0.04});
    MeshOptions options;
    options.size = 0.5;
    options.isImproved = false;
    options.maxWallElements = maxWallElements;
    RunContext context;
    return meshSolids(*plate, options, nullptr, context);
}

TEST(LeftElements, TellAWallThatIsKeptFlat)
{
    const MeshOutcome outcome = meshPlate(1000);
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

}  // namespace
}  // namespace mesher
