#include "pipeline/estimate_solids.h"

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace mesher {
namespace {

/// The estimate is within a factor of 1.5 of what meshing makes.
void expectGoodEstimate(const BrepModel& model, const MeshOptions& options)
{
    RunContext context;
    const Result<MeshEstimate> estimate = estimateSolidModel(model, options, nullptr, context);
    ASSERT_TRUE(estimate);
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
    RunContext context;
    const Result<MeshEstimate> estimate = estimateSolidModel(bar, options, nullptr, context);
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

TEST(EstimateSolids, KnowsThatSizesOfNearlyNothingAreTooMany)
{
    const BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    for (const char* entity : {"Edge1", "Face1", "Solid1"}) {
        MeshOptions options;
        options.distanceSizes = {{entity, 1e-300, 1.0, 0.0}};
        RunContext context;
        const MeshOutcome outcome = meshSolids(model, options, nullptr, context);
        ASSERT_EQ(outcome.report.failures.size(), 1u) << entity;
        EXPECT_NE(outcome.report.failures[0].message.find("--max-elements"), std::string::npos);
        EXPECT_EQ(outcome.report.failures[0].entity, std::string(entity) == "Solid1" ? "model" : entity);
        EXPECT_EQ(outcome.report.seconds.back().first, "estimate");
        const Result<MeshEstimate> estimate = estimateSolidModel(model, options, nullptr, context);
        ASSERT_TRUE(estimate);
        EXPECT_TRUE(std::isfinite(estimate->elements) && estimate->elements > 1e9) << estimate->elements;
    }
}

TEST(EstimateSolids, EndsWhenTheRunDoes)
{
    const BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    RunContext context;
    context.limitTime(0.0);
    const MeshOutcome outcome = meshSolids(model, {}, nullptr, context);
    EXPECT_EQ(outcome.report.stopReason, StopReason::TimeLimit);
    EXPECT_EQ(outcome.report.seconds.back().first, "estimate");
}

TEST(EstimateSolids, WantsSolids)
{
    BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    RunContext context;
    model.solids[BrepSolidId(0)].shells[0].isClosed = false;
    EXPECT_FALSE(estimateSolidModel(model, {}, nullptr, context));
    model.solids = {};
    EXPECT_FALSE(estimateSolidModel(model, {}, nullptr, context));
}

}  // namespace
}  // namespace mesher
