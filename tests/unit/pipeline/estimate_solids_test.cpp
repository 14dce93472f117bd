#include "pipeline/estimate_solids.h"

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

namespace mesher {
namespace {

/// The estimate is within a factor of 1.5 of what meshing makes.
void expectGoodEstimate(const BrepModel& model, const MeshOptions& options)
{
    const Result<MeshEstimate> estimate = estimateSolidModel(model, options, nullptr);
    ASSERT_TRUE(estimate);
    RunContext context;
    const MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    ASSERT_TRUE(outcome.mesh);
    const double real = static_cast<double>(outcome.mesh->tets.size());
    EXPECT_GT(estimate.value().elements, real / 1.5);
    EXPECT_LT(estimate.value().elements, 1.5 * real);
}

TEST(EstimateSolids, IsNearTheMeshOfAUniformSize)
{
    MeshOptions options;
    options.size = 0.08;
    expectGoodEstimate(makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value(), options);
    expectGoodEstimate(makeCylinder(Axes{}, 0.5, 1.0).value(), options);
}

TEST(EstimateSolids, FollowsASizeThatVariesInSpace)
{
    MeshOptions options;
    options.size = 0.2;
    options.sizeFormula = "0.03 + 0.2*x";
    expectGoodEstimate(makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value(), options);
}

TEST(EstimateSolids, FollowsCurvature)
{
    MeshOptions options;
    options.curvature = 40.0;
    expectGoodEstimate(makeTorus(Axes{}, 3.0, 1.0).value(), options);
}

/// About a narrow hollow facets are small, whatever the sizes and curvatures.
TEST(EstimateSolids, CountsWhatTheShapeItselfNeeds)
{
    const BrepModel box = makeBox({}, {4.0, 4.0, 4.0}).value();
    const BrepModel slot = makeBox({1.0, 1.0, 0.5}, {1.2, 1.2, 3.5}).value();
    MeshOptions options;
    options.size = 1.0;
    expectGoodEstimate(test::withHollow(box, slot), options);
}

/// Sizes so much larger than the body ask for nothing; its facets share what little is inside.
TEST(EstimateSolids, CountsNoMoreThanABarHasRoomFor)
{
    MeshOptions options;
    options.size = 1.0;
    const BrepModel bar = makeBox({}, {12.0, 0.4, 0.4}).value();
    const Result<MeshEstimate> estimate = estimateSolidModel(bar, options, nullptr);
    RunContext context;
    const MeshOutcome outcome = meshSolids(bar, options, nullptr, context);
    ASSERT_TRUE(estimate && outcome.mesh);
    EXPECT_LT(estimate->elements, 2.5 * static_cast<double>(outcome.mesh->tets.size()));
}

TEST(EstimateSolids, RefusesAMeshThatIsTooLargeBeforeItIsBegun)
{
    MeshOptions options;
    options.size = 1e-4;
    const BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    RunContext context;
    const MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    EXPECT_FALSE(outcome.mesh);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_EQ(outcome.report.failures[0].code, ErrorCode::OutOfRange);
    ASSERT_EQ(outcome.report.seconds.size(), 1u);
    EXPECT_EQ(outcome.report.seconds[0].first, "estimate");
}

TEST(EstimateSolids, WantsSolids)
{
    BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    model.solids[BrepSolidId(0)].shells[0].isClosed = false;
    EXPECT_FALSE(estimateSolidModel(model, {}, nullptr));
    model.solids = {};
    EXPECT_FALSE(estimateSolidModel(model, {}, nullptr));
}

}  // namespace
}  // namespace mesher
