#include "refinement/refine_volume.h"

#include "sizing/attractor_size.h"
#include "sizing/uniform_size.h"
#include "support/test_effort.h"
#include "unit/refinement/refinement_fixture.h"

#include <cmath>
#include <functional>
#include <string>

namespace mesher::test {
namespace {

struct Case
{
    std::string name;
    std::function<SampledSolid(double scale)> make;
    double size = 0.0;  ///< 0: by local feature size
};

std::vector<Case> cases()
{
    return {
        {"coarseBox",
         [](double s) {
             return sampledBox({1, 1, 1}, 1, s);
         },
         0.0},
        {"flatBox",
         [](double s) {
             return sampledBox({4, 2, 1}, 2, s);
         },
         0.0},
        {"boxOfOneSize",
         [](double s) {
             return sampledBox({1, 1, 1}, 5, s);
         },
         0.15},
        {"coarseSphere", [](double s) { return sampledSphere(1.0, 60, s); }, 0.0},
        {"sphereOfOneSize", [](double s) { return sampledSphere(1.0, 400, s); }, 0.15},
        {"cylinder", [](double s) { return sampledCylinder(1.0, 2.0, 25, s); }, 0.0},
        {"cylinderOfOneSize", [](double s) { return sampledCylinder(1.0, 2.0, 30, s); }, 0.19},
        {"torus", [](double s) { return sampledTorus(2.0, 1.0, 20, s); }, 0.0},
        {"torusOfOneSize", [](double s) { return sampledTorus(2.0, 1.0, 25, s); }, 0.25},
    };
}

class RefineVolume : public testing::TestWithParam<std::size_t>
{
protected:
    [[nodiscard]] Case chosen() const { return cases()[GetParam()]; }
    RefinedVolume run(SampledSolid& solid, const RefineVolumeOptions& base = {}) const
    {
        RefineVolumeOptions options = base;
        const UniformSize field(chosen().size > 0.0 ? chosen().size : 1.0);
        if (chosen().size > 0.0) {
            options.sizing.field = &field;
            options.sizing.usesLocalFeatureSize = false;
        }
        return refine(solid, options);
    }
};

TEST_P(RefineVolume, ReachesTheAnglesAndKeepsTheInvariants)
{
    SampledSolid solid = chosen().make(1.0);
    ASSERT_TRUE(isSound(solid));
    const double before = meshedVolume(solid);
    const RefinedVolume result = run(solid);
    EXPECT_TRUE(isSound(solid));
    EXPECT_EQ(result.stopReason, StopReason::Done);
    EXPECT_TRUE(result.left.empty());
    const DihedralRange range = dihedralRange(solid);
    EXPECT_GE(range.least, 18.0);
    EXPECT_LE(range.most, 155.0);
    EXPECT_EQ(result.tets, meshedTets(solid).size());
    EXPECT_EQ(countNonDelaunayFaces(solid.tetrahedralization.mesh(), DelaunayPart::Inside), 0u);
    EXPECT_EQ(result.counts.nonDelaunayFaces, 0u);
    // Splitting a curved surface brings the volume nearer to the exact one.
    EXPECT_LE(std::abs(meshedVolume(solid) - solid.volume), std::abs(before - solid.volume) + 1e-12);
}

TEST_P(RefineVolume, RefiningAgainChangesNothing)
{
    SampledSolid solid = chosen().make(1.0);
    run(solid);
    const std::uint64_t hash = meshHash3d(solid.tetrahedralization.mesh());
    // The local feature size of the refined mesh would be another one.
    RefineVolumeOptions options;
    options.sizing.usesLocalFeatureSize = chosen().size > 0.0;
    if (chosen().size == 0.0) options.sizing.usesLocalFeatureSize = false;
    const RefinedVolume again = run(solid, options);
    EXPECT_EQ(meshHash3d(solid.tetrahedralization.mesh()), hash);
    EXPECT_EQ(again.counts.qualityInsertions + again.counts.sizeInsertions, 0u);
    EXPECT_EQ(again.counts.facetSplits + again.counts.segmentSplits, 0u);
}

TEST_P(RefineVolume, IsTheSameInTwoRunsAndAtAnyPowerOfTwo)
{
    SampledSolid first = chosen().make(1.0);
    SampledSolid second = chosen().make(1.0);
    SampledSolid scaled = chosen().make(0x1p90);
    const RefinedVolume a = run(first);
    const RefinedVolume b = run(second);
    const RefinedVolume c = run(scaled);
    EXPECT_EQ(meshHash3d(first.tetrahedralization.mesh()), meshHash3d(second.tetrahedralization.mesh()));
    EXPECT_EQ(a.tets, b.tets);
    EXPECT_EQ(a.tets, c.tets);
    EXPECT_EQ(a.vertices, c.vertices);
    EXPECT_TRUE(isSound(scaled));
}

TEST_P(RefineVolume, KeepsAFrozenBoundary)
{
    SampledSolid solid = chosen().make(1.0);
    const std::size_t nodes = solid.splitter->mesh().nodes.size();
    const double volume = meshedVolume(solid);
    RefineVolumeOptions options;
    options.boundary = BoundaryPolicy::Frozen;
    const RefinedVolume result = run(solid, options);
    EXPECT_TRUE(isSound(solid));
    EXPECT_EQ(solid.splitter->mesh().nodes.size(), nodes);
    EXPECT_EQ(result.counts.facetSplits + result.counts.segmentSplits, 0u);
    EXPECT_NEAR(meshedVolume(solid), volume, 1e-12);
    std::uint64_t explained = 0;
    for (const NonDelaunayFaces3d& faces : result.nonDelaunayFaces) explained += faces.count;
    EXPECT_EQ(explained, countNonDelaunayFaces(solid.tetrahedralization.mesh(), DelaunayPart::Inside));
    EXPECT_EQ(explained, result.counts.nonDelaunayFaces);
}

INSTANTIATE_TEST_SUITE_P(Solids, RefineVolume, testing::Range<std::size_t>(0, cases().size()),
                         [](const auto& chosen) { return cases()[chosen.param].name; });

/// Beside facets that may not be split vertices are put short of the circumcentres, where nothing keeps them off the planes of other
/// faces: one flat tetrahedron would be followed by flatter ones.
TEST(RefineVolumeBesideCoarseFacets, MakesNoFlatTetrahedraFlatter)
{
    SampledSolid solid = sampledCylinder(1.0, 4.0, 8);
    const UniformSize field(0.2);
    RefineVolumeOptions options;
    options.boundary = BoundaryPolicy::Frozen;
    options.sizing.field = &field;
    options.sizing.usesLocalFeatureSize = false;
    const RefinedVolume result = refine(solid, options);
    EXPECT_TRUE(isSound(solid));
    EXPECT_GT(result.counts.shortInsertions, 100u);
    EXPECT_GT(dihedralRange(solid).least, 1.0);
}

/// Inside, edges are longer than the size; on the surface this solid brings them with it.
TEST(RefineVolumeSizes, MeanEdgesAreLongerThanTheSizeWanted)
{
    SampledSolid solid = sampledSphere(1.0, 1440);
    const UniformSize field(0.1);
    RefineVolumeOptions options;
    options.sizing.field = &field;
    options.sizing.usesLocalFeatureSize = false;
    refine(solid, options);
    double sum = 0.0;
    const std::vector<TetId> tets = meshedTets(solid);
    for (const TetId tet : tets) {
        const auto corner = cornersOf(solid, tet);
        for (const auto& [a, b] : kTetEdgeCorners) sum += length(corner[a] - corner[b]) / 6.0;
    }
    EXPECT_NEAR(sum / static_cast<double>(tets.size()), 0.127, 0.01);
}

TEST(RefineVolumeSizes, FollowASmallPlaceOfTheField)
{
    SampledSolid solid = sampledBox({1, 1, 1}, 4);
    DistanceProfile profile;
    profile.growth = 0.5;
    const AttractorSize field({{{0.4, 0.45, 0.55}, {0.4, 0.45, 0.55}, 0.01}}, profile);
    RefineVolumeOptions options;
    options.sizing.field = &field;
    const RefinedVolume result = refine(solid, options);
    EXPECT_EQ(result.stopReason, StopReason::Done);
    EXPECT_TRUE(isSound(solid));
    for (const TetId tet : meshedTets(solid)) {
        const auto corner = cornersOf(solid, tet);
        for (const auto& [a, b] : kTetEdgeCorners) {
            const Vec3 middle = 0.5 * (corner[a] + corner[b]);
            EXPECT_LT(length(corner[a] - corner[b]), 2.5 * field.sizeAt(middle));
        }
    }
}

TEST(RefineVolumeSizes, FallWithRefinementAndGrading)
{
    const auto tetsFor = [](double refinement, double grading) {
        SampledSolid solid = sampledBox({1, 1, 1}, 8);
        RefineVolumeOptions options;
        options.sizing.refinement = refinement;
        options.sizing.grading = grading;
        return refine(solid, options).tets;
    };
    const std::uint64_t coarse = tetsFor(1.0, 1.0);
    EXPECT_GT(tetsFor(2.0, 1.0), 3 * coarse);
    EXPECT_GT(tetsFor(2.0, 10.0), tetsFor(2.0, 1.0));
}

TEST(RefineVolumeMeasures, ReachTheirThresholds)
{
    for (const TetMeasureInfo& info : kTetMeasures) {
        SCOPED_TRACE(info.key);
        SampledSolid solid = sampledSphere(1.0, 200);
        RefineVolumeOptions options;
        options.quality.measure = info.measure;
        const RefinedVolume result = refine(solid, options);
        EXPECT_EQ(result.stopReason, StopReason::Done);
        EXPECT_TRUE(isSound(solid));
        for (const TetId tet : meshedTets(solid)) {
            EXPECT_GE(score(info.measure, cornersOf(solid, tet)), info.threshold - 1e-9);
        }
        EXPECT_LE(dihedralRange(solid).most, info.largestDihedral + 1e-9);
    }
}

/// What q1 and q7 do not see they would have to make far more vertices to be rid of: four times as many for q7 here.
TEST(RefineVolumeMeasures, AreNotHeldToAnglesThatTheyDoNotSeeUnlessAsked)
{
    const auto refineFor = [](TetMeasure measure, std::optional<double> largestDihedral, double& most) {
        SampledSolid solid = sampledTorus(2.0, 1.0, 20);
        RefineVolumeOptions options;
        options.quality.measure = measure;
        options.quality.largestDihedral = largestDihedral;
        const std::uint64_t vertices = refine(solid, options).vertices;
        most = dihedralRange(solid).most;
        return static_cast<double>(vertices);
    };
    double most = 0.0;
    const double ofQ1 = refineFor(TetMeasure::ShortestEdgeToCircumradius, {}, most);
    EXPECT_GT(most, 155.0);
    EXPECT_LE(refineFor(TetMeasure::InradiusToLargestAltitude, {}, most), 1.5 * ofQ1);
    EXPECT_GT(refineFor(TetMeasure::ShortestEdgeToCircumradius, 155.0, most), 1.2 * ofQ1);
    EXPECT_LE(most, 155.0 + 1e-9);
}

TEST(RefineVolumeMeasures, GivesUpWhatIsOutOfReachSoonAndKeepsTheUsual)
{
    const auto refineTo = [](std::optional<double> threshold, SampledSolid& solid) {
        RefineVolumeOptions options;
        options.quality.threshold = threshold;
        return refine(solid, options);
    };
    SampledSolid usual = sampledTorus(2.0, 1.0, 20);
    const RefinedVolume plain = refineTo({}, usual);
    EXPECT_FALSE(plain.unreachable.has_value());
    SampledSolid better = sampledTorus(2.0, 1.0, 20);
    EXPECT_FALSE(refineTo(0.33, better).unreachable.has_value());
    for (const double threshold : {0.42, 0.6, 0.9}) {
        SCOPED_TRACE(threshold);
        SampledSolid solid = sampledTorus(2.0, 1.0, 20);
        const RefinedVolume result = refineTo(threshold, solid);
        ASSERT_TRUE(result.unreachable.has_value());
        EXPECT_GE(result.unreachable->bad, 20U);
        EXPECT_LT(result.unreachable->best, threshold);
        EXPECT_LT(result.vertices, 4 * plain.vertices);
        EXPECT_TRUE(isSound(solid));
        EXPECT_GT(dihedralRange(solid).least, 18.0);
    }
}

TEST(RefineVolumeLimits, EndsAtEachLimitWithASoundMesh)
{
    const auto stopFor = [](const BudgetLimits& limits) {
        SampledSolid solid = sampledTorus(2.0, 1.0, 20);
        RefineVolumeOptions options;
        options.limits = limits;
        const RefinedVolume result = refine(solid, options);
        EXPECT_TRUE(isSound(solid));
        EXPECT_FALSE(result.left.empty());
        EXPECT_EQ(result.left.front().reason, LeftReason3d::Unfinished);
        return result.stopReason;
    };
    BudgetLimits operations;
    operations.maxOperations = 40;
    EXPECT_EQ(stopFor(operations), StopReason::OperationLimit);
    BudgetLimits vertices;
    vertices.maxVertices = 2000;
    EXPECT_EQ(stopFor(vertices), StopReason::VertexLimit);
    BudgetLimits elements;
    elements.maxElements = 9000;
    EXPECT_EQ(stopFor(elements), StopReason::ElementLimit);
}

TEST(RefineVolumeLimits, EndsWithoutHeadwayAtTheSameMeshAndNamesWhereTheWorkWent)
{
    const auto run = [](const WorkAllowance& allowance, std::uint64_t& hash) {
        SampledSolid solid = sampledWedge(2.0, 0.4, 2.0, 4);
        RefineVolumeOptions options;
        options.allowance = allowance;
        RefinedVolume result = refine(solid, options);
        EXPECT_TRUE(isSound(solid));
        hash = meshHash3d(solid.tetrahedralization.mesh());
        return result;
    };
    std::uint64_t hash = 0;
    const RefinedVolume whole = run({}, hash);
    EXPECT_FALSE(whole.hasStalled);
    EXPECT_TRUE(whole.costliest.empty());

    const RefinedVolume ended = run({500.0, 0.0, 5.0}, hash);
    EXPECT_TRUE(ended.hasStalled);
    EXPECT_EQ(ended.stopReason, StopReason::CannotImprove);
    EXPECT_LT(ended.vertices, whole.vertices);
    ASSERT_FALSE(ended.costliest.empty());
    EXPECT_LE(ended.costliest.front().entity.dimension, 2) << "an edge or a face of the wedge";
    EXPECT_NE(ended.costliest.front().entity.index, EntityRef::kNone);
    double shares = 0.0;
    for (const WorkLedger3d::Entry& entry : ended.costliest) shares += entry.share;
    EXPECT_GT(shares, 0.3);
    EXPECT_LE(shares, 1.0 + 1e-12);
    for (const LeftTet3d& left : ended.left) EXPECT_NE(left.reason, LeftReason3d::Unfinished);
    std::uint64_t again = 0;
    run({500.0, 0.0, 5.0}, again);
    EXPECT_EQ(again, hash);
}

TEST(RefineVolumeLimits, TellsProgressAndCanBeCancelled)
{
    SampledSolid solid = sampledTorus(2.0, 1.0, 20);
    double last = 0.0;
    int reports = 0;
    RunSettings settings;
    settings.progress = [&](std::string_view, double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return ++reports < 4;
    };
    RunContext context(settings);
    const auto result = refineVolume(solid.tetrahedralization, *solid.splitter, {}, context);
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->stopReason, StopReason::Cancelled);
    EXPECT_TRUE(isSound(solid));
}

TEST(RefineVolumeChecks, RunAtFullLevelAndChangeNothing)
{
    SampledSolid checked = sampledCylinder(1.0, 2.0, 25);
    SampledSolid plain = sampledCylinder(1.0, 2.0, 25);
    RunSettings settings;
    settings.checkLevel = CheckLevel::Full;
    RunContext context(settings);
    ASSERT_TRUE(refineVolume(checked.tetrahedralization, *checked.splitter, {}, context).hasValue());
    refine(plain);
    EXPECT_EQ(meshHash3d(checked.tetrahedralization.mesh()), meshHash3d(plain.tetrahedralization.mesh()));
}

TEST(RefineVolumeOptionsRange, IsRefusedOutside)
{
    SampledSolid solid = sampledBox({1, 1, 1}, 1);
    const auto isRefused = [&](const std::function<void(RefineVolumeOptions&)>& spoil) {
        RefineVolumeOptions options;
        spoil(options);
        RunContext context;
        const auto result = refineVolume(solid.tetrahedralization, *solid.splitter, options, context);
        return !result.hasValue() && result.error().code == ErrorCode::InvalidArgument;
    };
    EXPECT_TRUE(isRefused([](auto& o) { o.sizing.refinement = 0.0; }));
    EXPECT_TRUE(isRefused([](auto& o) { o.sizing.grading = -1.0; }));
    EXPECT_TRUE(isRefused([](auto& o) { o.floor = std::nan(""); }));
    EXPECT_TRUE(isRefused([](auto& o) { o.leastGap = -1.0; }));
    EXPECT_TRUE(isRefused([](auto& o) { o.quality.threshold = 0.95; }));
    EXPECT_TRUE(isRefused([](auto& o) { o.quality.largestDihedral = 80.0; }));
}

TEST(RefineVolumeSmallAngles, DoNotSpoilWhatIsPossibleBesideAnAngleOf27Degrees)
{
    SampledSolid solid = sampledWedge(2.0, 1.0, 2.0, 10);
    const UniformSize field(0.2);
    RefineVolumeOptions options;
    options.sizing.field = &field;
    options.sizing.usesLocalFeatureSize = false;
    EXPECT_EQ(refine(solid, options).stopReason, StopReason::Done);
    EXPECT_GE(dihedralRange(solid).least, 18.0);
    EXPECT_LE(dihedralRange(solid).most, 155.0);
}

TEST(RefineVolumeSmallAngles, AreBlamedForWhatIsLeft)
{
    SampledSolid solid = sampledWedge(2.0, 0.4, 2.0, 4);
    const RefinedVolume result = refine(solid);
    EXPECT_TRUE(isSound(solid));
    EXPECT_EQ(result.stopReason, StopReason::CannotImprove);
    ASSERT_FALSE(result.left.empty());
    EXPECT_EQ(result.leftForSmallAngles, result.left.size());
    for (const LeftTet3d& left : result.left) {
        ASSERT_TRUE(left.angle.has_value());
        EXPECT_LT(left.angle->degrees, 60.0);
    }
    std::uint64_t told = 0;
    for (const LeftPlace3d& place : result.places) {
        told += place.count;
        EXPECT_EQ(place.reason, LeftReason3d::SmallInputAngle);
        EXPECT_LT(place.leastDihedral, 18.7);
        // An edge between two faces, or a vertex between two edges.
        EXPECT_EQ(place.entity[1].dimension, place.entity[0].dimension + 1);
        EXPECT_LT(place.entity[1], place.entity[2]);
    }
    EXPECT_EQ(told, result.left.size());
}

TEST(RefineVolumeGaps, AreNamedAndNotResolvedBelowTheLeastOne)
{
    const auto beam = [] { return sampledBox({1.0, 0.01, 0.01}, 1); };
    const UniformSize field(0.25);
    RefineVolumeOptions options;
    options.sizing.field = &field;
    options.sizing.usesLocalFeatureSize = false;
    SampledSolid resolved = beam();
    const RefinedVolume fine = refine(resolved, options);
    EXPECT_TRUE(fine.gaps.empty());
    EXPECT_GT(fine.counts.segmentSplits, 200u);

    SampledSolid narrow = beam();
    options.leastGap = 0.02;
    const RefinedVolume coarse = refine(narrow, options);
    EXPECT_TRUE(isSound(narrow));
    EXPECT_LT(coarse.counts.segmentSplits, 20u);
    ASSERT_FALSE(coarse.gaps.empty());
    for (const NarrowGap& gap : coarse.gaps) {
        EXPECT_EQ(gap.edge.dimension, 1);
        EXPECT_NE(gap.edge, gap.other);
        EXPECT_GT(gap.width, 0.0099);
        EXPECT_LT(gap.width, 0.02);
    }
}

TEST(RefineVolumeFuzz, KeepsTheInvariantsForRandomSolids)
{
    for (int i = 0; i < repetitions(60); ++i) {
        SCOPED_TRACE(i);
        Random random(static_cast<std::uint64_t>(i) + 1);
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(180)) - 80);
        SampledSolid solid;
        switch (random.below(5)) {
            case 0:
                solid =
                    sampledBox({random.between(0.5, 4.0), random.between(0.5, 4.0), random.between(0.5, 4.0)},
                               1 + random.below(4), scale);
                break;
            case 1: solid = sampledSphere(random.between(0.1, 9.0), 20 + random.below(300), scale); break;
            case 2:
                solid = sampledCylinder(1.0, random.between(0.5, 4.0), 12 + random.below(20), scale);
                break;
            case 3: solid = sampledTorus(2.0, 1.0, 20 + 5 * random.below(2), scale); break;
            default:
                solid = sampledWedge(random.between(0.5, 3.0), random.between(0.3, 3.0), 2.0,
                                     2 + random.below(5));
                break;
        }
        RefineVolumeOptions options;
        options.sizing.refinement = random.between(0.4, 1.2);
        options.sizing.grading = random.between(0.5, 8.0);
        options.quality.measure = kTetMeasures[random.below(8)].measure;
        if (random.below(4) == 0) options.boundary = BoundaryPolicy::Frozen;
        options.limits.maxVertices = 30000;
        const RefinedVolume result = refine(solid, options);
        ASSERT_TRUE(isSound(solid));
        // Where q7 comes near its threshold, it asks for many vertices: it sees few kinds of bad tetrahedra.
        if (options.quality.measure == TetMeasure::InradiusToLargestAltitude) continue;
        EXPECT_NE(result.stopReason, StopReason::VertexLimit);
    }
}

}  // namespace
}  // namespace mesher::test
