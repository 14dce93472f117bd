#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "quality/tet_measures.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

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

/// The least q3 of all tetrahedra, and their mean radius ratio.
std::pair<double, double> shapesOf(const ClassifiedMesh& mesh)
{
    double least = 1.0;
    double sum = 0.0;
    for (const auto& tet : mesh.tets) {
        TetCorners corner;
        for (std::size_t i = 0; i < 4; ++i) corner[i] = mesh.nodes[tet.node[i]].position;
        least = std::min(least, score(TetMeasure::VolumeLength, corner));
        sum += score(TetMeasure::RadiusRatio, corner);
    }
    return {least, sum / static_cast<double>(mesh.tets.size())};
}

/// Balls and rings whose size nothing but the curvature tells had a vertex at their centre, and a star of spires around it.
TEST(FineFeatures, OfTheSurfaceGrowInwardWithoutSpires)
{
    const auto ball = makeSphere({}, 3.0);
    const auto ring = makeTorus({}, 4.0, 1.5);
    ASSERT_TRUE(ball && ring);
    for (const BrepModel* model : {&*ball, &*ring}) {
        for (const double curvature : {12.0, 20.0, 50.0}) {
            SCOPED_TRACE(std::to_string(model->faces.size()) + " " + std::to_string(curvature));
            MeshOptions options;
            options.curvature = curvature;
            const MeshOutcome outcome = meshWithoutImprovement(*model, options);
            expectGoodAngles(outcome);
            ASSERT_TRUE(outcome.mesh);
            const auto [volumeLength, radiusRatio] = shapesOf(*outcome.mesh);
            EXPECT_GE(volumeLength, 0.2);
            EXPECT_GE(radiusRatio, 0.7);
        }
    }
}

TEST(FineFeatures, GrowInwardAsFastAsTheGradingAllowsWithoutASize)
{
    const auto ball = makeSphere({}, 3.0);
    ASSERT_TRUE(ball);
    const auto tetsFor = [&](double grading) {
        MeshOptions options;
        options.curvature = 40.0;
        options.grading = grading;
        const MeshOutcome outcome = meshWithoutImprovement(*ball, options);
        return outcome.mesh ? outcome.mesh->tets.size() : 0;
    };
    // Quality alone lets tetrahedra grow about as fast as at 4.
    const std::size_t usual = tetsFor(1.0);
    EXPECT_GT(usual, 0u);
    EXPECT_GT(5 * tetsFor(20.0), 6 * usual);
}

TEST(FineFeatures, ReachTheAnglesWhateverLambdaIs)
{
    const BrepModel model = cubeAroundAFlatHollow(6.0, 0.03);
    std::size_t least = 0, most = 0;
    for (const double lambda : {1.0, 2.0, 5.0, 1e6}) {
        SCOPED_TRACE(lambda);
        MeshOptions options;
        options.lambda = lambda;
        const MeshOutcome outcome = meshWithoutImprovement(model, options);
        expectGoodAngles(outcome);
        for (const LeftElements& left : outcome.report.left)
            ADD_FAILURE() << left.count << " left: " << left.reason;
        ASSERT_TRUE(outcome.mesh);
        const std::size_t tets = outcome.mesh->tets.size();
        least = least == 0 ? tets : std::min(least, tets);
        most = std::max(most, tets);
    }
    EXPECT_LT(most, 1.3 * static_cast<double>(least));
}

}  // namespace
}  // namespace mesher::test
