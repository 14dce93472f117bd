#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <string>

namespace mesher::test {
namespace {

MeshOutcome meshWithoutImprovement(const BrepModel& model, MeshOptions options)
{
    options.isImproved = false;
    RunContext context;
    MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    return outcome;
}

void expectGoodAngles(const MeshOutcome& outcome)
{
    ASSERT_TRUE(outcome.mesh && outcome.report.tetQuality);
    EXPECT_GE(outcome.report.tetQuality->dihedral.least(), 18.0);
    EXPECT_LE(outcome.report.tetQuality->dihedral.largest(), 155.0);
}

/// A flat hollow in a cube whose edges see hundreds of its vertices: tetrahedra by the hundred are around each of them.
BrepModel cubeAroundAFlatHollow(double side, double thickness)
{
    const Vec3 low{0.4 * side, 0.45 * side, 0.5 * side};
    return withHollow(*makeBox({}, {side, side, side}), *makeBox(low, low + Vec3{1.5, 2.0, thickness}));
}

TEST(FineFeatures, AreMeshedWellInACoarseBoxOfAnySize)
{
    for (const double side : {5.0, 20.0, 200.0}) {
        for (const double thickness : {0.04, 0.2}) {
            SCOPED_TRACE(std::to_string(side) + " " + std::to_string(thickness));
            const MeshOutcome outcome = meshWithoutImprovement(cubeAroundAFlatHollow(side, thickness), {});
            expectGoodAngles(outcome);
            ASSERT_TRUE(outcome.mesh);
            EXPECT_LT(outcome.mesh->tets.size(), 100'000u);
        }
    }
}

}  // namespace
}  // namespace mesher::test
