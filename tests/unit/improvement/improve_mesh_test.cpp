#include "unit/improvement/improvement_fixture.h"

#include "mesh/classified_mesh_hash.h"
#include "mesh/mesh_check.h"

namespace mesher {
namespace {

using test::improved;
using test::isImprovementOf;
using test::refinedMesh;
using test::SolidExample;

TEST(ImproveMesh, MakesNothingWorseAndKeepsTheBoundary)
{
    ImprovementCounts sum;
    for (const SolidExample& example : test::solidExamples()) {
        SCOPED_TRACE(example.name);
        const ClassifiedMesh before = refinedMesh(example);
        ClassifiedMesh after = before;
        const Improvement result = improved(after, example.model);
        EXPECT_TRUE(isImprovementOf(after, before, example.model));
        EXPECT_LT(result.counts.badAfter, result.counts.badBefore / 20);
        EXPECT_GT(result.scoreAfter, result.scoreBefore);
        EXPECT_GT(tetQualityOf(after).dihedral.least(), 25.0);
        EXPECT_LT(tetQualityOf(after).dihedral.largest(), 146.0);
        sum.edgeRemovals += result.counts.edgeRemovals;
        sum.faceRemovals += result.counts.faceRemovals;
        sum.boundarySwaps += result.counts.boundarySwaps;
        sum.innerMoves += result.counts.innerMoves;
        sum.faceMoves += result.counts.faceMoves;
        sum.edgeMoves += result.counts.edgeMoves;
    }
    // Else the property would be tested of nothing.
    EXPECT_GT(sum.edgeRemovals, 100u);
    EXPECT_GT(sum.faceRemovals, 50u);
    EXPECT_GT(sum.boundarySwaps, 5u);
    EXPECT_GT(sum.innerMoves, 50u);
    EXPECT_GT(sum.faceMoves, 20u);
    EXPECT_GT(sum.edgeMoves, 2u);
}

TEST(ImproveMesh, HelpsWithTheirSurroundingsThoseThatNothingHelpsAlone)
{
    const std::vector<SolidExample> thin = {
        {"disc", makeCylinder(Axes{}, 2.0, 0.35).value(), 0.35},
        {"ring", makeTorus(Axes{}, 2.0, 0.25).value(), 0.25},
        {"plate", makeBox({0, 0, 0}, {4, 3, 0.3}).value(), 0.3},
    };
    for (const SolidExample& example : thin) {
        SCOPED_TRACE(example.name);
        const ClassifiedMesh before = refinedMesh(example);
        ClassifiedMesh after = before;
        const Improvement result = improved(after, example.model);
        EXPECT_GT(result.counts.surroundings, 0u);
        EXPECT_EQ(result.counts.badAfter, 0u);
        EXPECT_TRUE(isImprovementOf(after, before, example.model));
    }
}

TEST(ImproveMesh, KeepsTheFaceBetweenTwoSolids)
{
    const BrepModel model = test::makeTwoCubes();
    const ClassifiedMesh cube = refinedMesh({"cube", makeBox({0, 0, 0}, {1, 1, 1}).value(), 0.12});
    const ClassifiedMesh before = test::twoCubesOf(cube, model);
    ASSERT_TRUE(checkMesh(before).isValid()) << checkMesh(before).problems().front();
    ClassifiedMesh after = before;
    const Improvement result = improved(after, model);
    EXPECT_TRUE(isImprovementOf(after, before, model));
    EXPECT_GT(result.counts.boundarySwaps + result.counts.faceMoves, 10u);
    const MeshCheckReport report = checkMesh(after);
    ASSERT_EQ(report.volumeOfSolid.size(), 2u);
    for (const auto& [solid, volume] : report.volumeOfSolid) EXPECT_NEAR(volume, 1.0, 1e-12);
    EXPECT_GT(tetQualityOf(after).dihedral.least(), 24.0);
}

TEST(ImproveMesh, ComesToTheSameMeshTwice)
{
    const SolidExample example = test::solidExamples().back();
    const ClassifiedMesh before = refinedMesh(example);
    ClassifiedMesh first = before;
    ClassifiedMesh second = before;
    improved(first, example.model);
    improved(second, example.model);
    EXPECT_EQ(classifiedMeshHash(first), classifiedMeshHash(second));
    EXPECT_NE(classifiedMeshHash(first), classifiedMeshHash(before));
}

TEST(ImproveMesh, MakesNothingWorseWhenAskedAgain)
{
    const SolidExample example = test::solidExamples().front();
    ClassifiedMesh once = refinedMesh(example);
    improved(once, example.model);
    ClassifiedMesh twice = once;
    const Improvement again = improved(twice, example.model);
    EXPECT_GE(again.scoreAfter, again.scoreBefore);
    EXPECT_TRUE(isImprovementOf(twice, once, example.model));
}

TEST(ImproveMesh, LeavesAFrozenBoundaryAsItIs)
{
    const SolidExample example = test::solidExamples()[1];
    const ClassifiedMesh before = refinedMesh(example);
    ClassifiedMesh after = before;
    ImprovementOptions options;
    options.boundary = BoundaryChanges::None;
    const Improvement result = improved(after, example.model, options);
    EXPECT_EQ(result.counts.boundarySwaps + result.counts.faceMoves + result.counts.edgeMoves, 0u);
    EXPECT_GT(result.counts.innerMoves, 0u);
    EXPECT_TRUE(isImprovementOf(after, before, example.model));
    for (std::size_t i = 0; i < before.triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(after.nodes[after.triangles[i].node[k]].position,
                      before.nodes[before.triangles[i].node[k]].position);
        }
    }
}

TEST(ImproveMesh, SaysWhyItStopped)
{
    const SolidExample example = test::solidExamples().front();
    const ClassifiedMesh before = refinedMesh(example);
    ImprovementOptions options;
    options.limits.maxOperations = 0;
    ClassifiedMesh after = before;
    EXPECT_EQ(improved(after, example.model, options).stopReason, StopReason::OperationLimit);
    EXPECT_EQ(classifiedMeshHash(after), classifiedMeshHash(before));
    options.limits.maxOperations = 30;
    const Improvement some = improved(after, example.model, options);
    EXPECT_EQ(some.stopReason, StopReason::OperationLimit);
    EXPECT_LT(some.counts.badAfter, some.counts.badBefore);
    EXPECT_TRUE(isImprovementOf(after, before, example.model));
    options = {};
    options.wantedAngle = 10.0;
    after = before;
    const Improvement nothing = improved(after, example.model, options);
    EXPECT_EQ(nothing.stopReason, StopReason::Done);
    EXPECT_EQ(nothing.counts.passes, 0u);
    options.wantedAngle = 55.0;
    EXPECT_EQ(improved(after, example.model, options).stopReason, StopReason::CannotImprove);
}

TEST(ImproveMesh, EndsWithASoundMeshWhenCancelled)
{
    const SolidExample example = test::solidExamples().front();
    const ClassifiedMesh before = refinedMesh(example);
    ClassifiedMesh after = before;
    int reports = 0;
    RunSettings settings;
    settings.progress = [&](std::string_view, double) { return ++reports < 20; };
    RunContext context(settings);
    const Result<Improvement> result = improveMesh(after, example.model, {}, context);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->stopReason, StopReason::Cancelled);
    EXPECT_TRUE(isImprovementOf(after, before, example.model));
    EXPECT_NE(classifiedMeshHash(after), classifiedMeshHash(before));
}

TEST(ImproveMesh, RefusesAnAngleOutOfRange)
{
    ClassifiedMesh mesh;
    RunContext context;
    for (const double angle : {0.0, -1.0, 61.0}) {
        ImprovementOptions options;
        options.wantedAngle = angle;
        const Result<Improvement> result = improveMesh(mesh, BrepModel{}, options, context);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::InvalidArgument);
    }
}

}  // namespace
}  // namespace mesher
