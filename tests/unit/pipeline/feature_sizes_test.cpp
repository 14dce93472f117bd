#include "pipeline/feature_sizes.h"

#include "brep/analytic/solids.h"
#include "pipeline/mesh_model.h"
#include "pipeline/mesh_solids.h"
#include "refinement/refine_volume.h"
#include "sizing/size_bounds.h"
#include "support/model_union.h"
#include "tetrahedralization/tetrahedralize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace mesher::test {
namespace {

MeshOptions atRefinement(std::optional<double> refinement)
{
    MeshOptions options;
    options.refinement = refinement;
    return options;
}

ClassifiedMesh meshOf(const BrepModel& model, const MeshOptions& options)
{
    RunContext context;
    MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    return outcome.mesh.value_or(ClassifiedMesh{});
}

/// A sphere with a small spherical hollow near its top.
BrepModel ballWithHollow()
{
    Axes above;
    above.origin = {0.0, 0.0, 8.0};
    return withHollow(*makeSphere({}, 10.0), *makeSphere(above, 1.0));
}

/// Tetrahedra whose middle is within a distance of the hollow's centre.
std::size_t countNear(const ClassifiedMesh& mesh, double distance)
{
    return static_cast<std::size_t>(std::count_if(mesh.tets.begin(), mesh.tets.end(), [&](const auto& tet) {
        Vec3 middle;
        for (const NodeId node : tet.node) middle = middle + 0.25 * mesh.nodes[node].position;
        return length(middle - Vec3{0.0, 0.0, 8.0}) < distance;
    }));
}

TEST(FeatureSizes, MakeElementsSmallerAboutSmallFeatures)
{
    const BrepModel model = ballWithHollow();
    std::size_t before = 0, beforeNear = 0;
    for (const double refinement : {1.0, 2.0, 3.0}) {
        const ClassifiedMesh mesh = meshOf(model, atRefinement(refinement));
        const std::size_t near = countNear(mesh, 2.0);
        EXPECT_GT(mesh.tets.size(), before) << refinement;
        // Not by the cube of the ratio: sizes grow with the distance.
        EXPECT_GT(2 * near, 3 * beforeNear) << refinement;
        before = mesh.tets.size();
        beforeNear = near;
    }
    const ClassifiedMesh coarse = meshOf(model, atRefinement(std::nullopt));
    EXPECT_LT(coarse.tets.size(), before);
}

TEST(FeatureSizes, AreTimesSmallerByTheRefinementAndGrowAsAsked)
{
    const BrepModel model = *makeBox({}, {4.0, 4.0, 1.0});
    const RegionSides sides = *regionSidesOf(model);
    RunContext context;
    const FeatureSizes one = featureSizes(model, sides, {}, 1.0, 1.0, context);
    const FeatureSizes three = featureSizes(model, sides, {}, 3.0, 1.0, context);
    const FeatureSizes slow = featureSizes(model, sides, {}, 3.0, 4.0, context);
    ASSERT_TRUE(one.field && three.field && slow.field);
    for (const Vec3& corner : {Vec3{0.0, 0.0, 0.0}, Vec3{4.0, 4.0, 1.0}}) {
        // At most the height of the box, and not below the height of a triangle with edges so long.
        EXPECT_LE(one.field->sizeAt(corner), kEdgeOfFeatureScale);
        EXPECT_GE(one.field->sizeAt(corner), 0.5 * kEdgeOfFeatureScale);
        EXPECT_NEAR(three.field->sizeAt(corner), one.field->sizeAt(corner) / 3.0, 1e-9);
    }
    const Vec3 corner, off = {-3.0, 0.0, 0.0};
    EXPECT_NEAR(three.field->sizeAt(off), three.field->sizeAt(corner) + 3.0, 1e-9);
    EXPECT_NEAR(slow.field->sizeAt(off), slow.field->sizeAt(corner) + 0.75, 1e-9);
}

/// The thesis measures features on the tetrahedralization of the run itself, and splits by length scales alone.
std::uint64_t verticesByTheThesis(const BrepModel& model, double refinement)
{
    RunContext context;
    Result<SurfaceSample> sample = sampleSurface(model, {}, context);
    Result<Tetrahedralization> made = tetrahedralize(*sample->surface, *regionSidesOf(model), {}, context);
    RefineVolumeOptions options;
    options.sizing.usesLocalFeatureSize = true;
    options.sizing.refinement = refinement;
    return refineVolume(made->tets, *sample->surface, options, context)->vertices;
}

TEST(FeatureSizes, AskForNoMoreVerticesThanTheRulesOfTheThesis)
{
    for (const BrepModel& model :
         {*makeBox({}, {4.0, 4.0, 1.0}), *makeCylinder({}, 1.0, 3.0), *makeTorus({}, 3.0, 1.0)}) {
        for (const double refinement : {1.0, 3.0}) {
            const double ours = static_cast<double>(meshOf(model, atRefinement(refinement)).nodes.size());
            const double theirs = static_cast<double>(verticesByTheThesis(model, refinement));
            EXPECT_LE(ours, 1.05 * theirs) << refinement;
            EXPECT_GT(4.0 * ours, theirs) << refinement;
        }
    }
}

TEST(FeatureSizes, AreNotTheThicknessOfWallsThatAreKeptFlat)
{
    const auto countOf = [](double thickness, std::optional<std::uint64_t> most) {
        MeshOptions options = atRefinement(2.0);
        options.maxWallElements = most;
        return meshOf(*makeBox({}, {10.0, 6.0, thickness}), options).tets.size();
    };
    EXPECT_LT(countOf(0.01, {}), 1000U);  // 20 million good ones
    EXPECT_GT(countOf(0.5, {}), 5000U);
    EXPECT_LT(countOf(0.5, 0), 1000U);
}

TEST(FeatureSizes, OfAUsersSizeAreNone)
{
    const BrepModel model = *makeBox({}, {4.0, 4.0, 4.0});
    MeshOptions options;
    options.size = 1.0;
    const std::size_t without = meshOf(model, options).tets.size();
    options.refinement = 2.0;  // sizes of 2 at least: those of 1 hold
    const std::size_t with = meshOf(model, options).tets.size();
    EXPECT_NEAR(static_cast<double>(with), static_cast<double>(without), 0.1 * static_cast<double>(without));
}

TEST(FeatureSizes, OfFacesInSpaceAreThoseOnTheFaces)
{
    const BrepModel model = *makeBox({}, {4.0, 4.0, 1.0});
    MeshOptions options = atRefinement(1.0);
    options.dimension = 2;
    std::size_t before = 0;
    for (const double refinement : {1.0, 3.0}) {
        options.refinement = refinement;
        RunContext context;
        const MeshOutcome outcome = meshModel(model, options, nullptr, 2, context);
        ASSERT_TRUE(outcome.mesh);
        EXPECT_GT(outcome.mesh->triangles.size(), 3 * before);
        before = outcome.mesh->triangles.size();
    }
}

TEST(FeatureSizes, MakeTheSameMeshInEveryRunWithAnyNumberOfThreads)
{
    const BrepModel model = ballWithHollow();
    RunContext one;
    RunSettings settings;
    settings.threads = 3;
    RunContext three(settings);
    const MeshOutcome first = meshSolids(model, atRefinement(2.0), nullptr, one);
    const MeshOutcome second = meshSolids(model, atRefinement(2.0), nullptr, three);
    ASSERT_TRUE(first.mesh && second.mesh);
    EXPECT_EQ(first.report.meshHash, second.report.meshHash);
}

}  // namespace
}  // namespace mesher::test
