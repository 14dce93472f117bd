#include "surface_sampling/surface_refinement.h"

#include "brep/analytic/bspline_surface.h"
#include "brep/analytic/plane_surface.h"
#include "brep/analytic/round_surfaces.h"
#include "sizing/size_bounds.h"
#include "support/face_examples.h"
#include "surface_sampling/face_flips.h"
#include "surface_sampling/face_mesh_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <utility>

namespace mesher::test {
namespace {

constexpr double kPi = std::numbers::pi;

struct Refined
{
    FaceMesh mesh;
    FaceMeshCheck check;
    FaceRefinementCounts counts;
    StopReason stopReason = StopReason::Done;
    std::size_t proposals = 0;
};

Refined refineFrozen(const FaceExample& example, const FaceRefinementOptions& options)
{
    RunContext context;
    Budget budget({.maxVertices = 2'000'000}, context);
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> made = example.mesh(geometry);
    EXPECT_TRUE(made.hasValue());
    Refined result;
    result.mesh = std::move(*made);
    makeSurfaceDelaunay(result.mesh, geometry, budget);
    const FrozenBoundary boundary;
    FaceRefiner refiner(result.mesh, geometry, boundary, options);
    refiner.queueAll();
    result.stopReason = refiner.refine(budget);
    result.counts = refiner.counts();
    result.proposals = refiner.takeProposals().size();
    result.check = checkFaceMesh(result.mesh, geometry);
    return result;
}

/// Circumradii are at most the size over sqrt(2), so that edges have it on average.
constexpr double kLongestOverSize = 2.0 * kEdgeSizeBounds.facet;

void expectSound(const Refined& refined)
{
    EXPECT_EQ(refined.check.report.problem, "");
    EXPECT_EQ(refined.check.components, 1u);
    EXPECT_EQ(refined.check.nonDelaunayEdges, 0u);
    EXPECT_LT(refined.check.largestDistance, 1e-12);
    EXPECT_EQ(refined.counts.splits.lostWalks + refined.counts.splits.foldedStars, 0u);
    EXPECT_EQ(refined.stopReason, StopReason::Done);
    EXPECT_EQ(refined.proposals, 0u) << "the boundary is frozen";
}

/// The same, of a face without a border: nothing may be left.
void expectSoundAndGood(const Refined& refined, double size)
{
    expectSound(refined);
    EXPECT_EQ(refined.counts.leftForResolution, 0u);
    EXPECT_GE(smallestAngle(refined.mesh), 30.0 - 1e-6);
    EXPECT_LE(longestEdge(refined.mesh), kLongestOverSize * size * (1.0 + 1e-9));
    EXPECT_GT(longestEdge(refined.mesh), 0.9 * size) << "refined far more than asked";
}

TEST(SurfaceRefinement, RefinesAPlaneSquareInsideOfAFrozenBoundary)
{
    FaceRefinementOptions options;
    options.criteria.maxSize = 0.12 / kLongestOverSize;
    const Refined refined = refineFrozen(
        gridFace(std::make_shared<PlaneSurface>(PlaneFrame{}), {0.0, 1.0}, {0.0, 1.0}, 10, 10), options);
    expectSound(refined);
    EXPECT_EQ(refined.check.eulerCharacteristic(), 1);
    EXPECT_NEAR(areaOf(refined.mesh), 1.0, 1e-12);
    EXPECT_GE(smallestAngle(refined.mesh), 30.0);
    EXPECT_GT(refined.counts.sizeInsertions, 50u);
}

TEST(SurfaceRefinement, LeavesFacetsWhoseCentreLiesBeyondAFrozenBoundary)
{
    FaceRefinementOptions options;
    options.criteria.maxSize = 0.03;
    const Refined refined = refineFrozen(
        gridFace(std::make_shared<PlaneSurface>(PlaneFrame{}), {0.0, 1.0}, {0.0, 1.0}, 10, 10), options);
    expectSound(refined);
    EXPECT_GT(refined.counts.leftForResolution, 0u);
    EXPECT_NEAR(longestEdge(refined.mesh), 0.1, 1e-12) << "only sides of the boundary are that long";
}

TEST(SurfaceRefinement, MeshesAWholeSphereFromAnOctahedron)
{
    FaceRefinementOptions options;
    options.criteria.maxSize = 0.06;
    const Refined refined = refineFrozen(octahedronOnSphere(1.0), options);
    expectSoundAndGood(refined, 0.06);
    EXPECT_EQ(refined.check.eulerCharacteristic(), 2);
    EXPECT_NEAR(areaOf(refined.mesh), 4.0 * kPi, 0.012);
}

TEST(SurfaceRefinement, NeedsAboutAsManyVerticesOnTheThesisSphereAsItsTable)
{
    FaceRefinementOptions options;
    options.criteria.rho = 10.0;
    const Refined refined = refineFrozen(octahedronOnSphere(1.0), options);
    expectSound(refined);
    EXPECT_GE(smallestAngle(refined.mesh), 30.0);
    EXPECT_NEAR(static_cast<double>(refined.check.vertices), 3323.0, 0.05 * 3323.0);
}

TEST(SurfaceRefinement, MeshesATorusAcrossBothSeams)
{
    FaceRefinementOptions options;
    options.criteria.maxSize = 0.1;
    const Refined refined = refineFrozen(gridFace(std::make_shared<TorusSurface>(Axes{}, 2.0, 0.5),
                                                  {0.0, 2.0 * kPi}, {0.0, 2.0 * kPi}, 12, 6, {true, true}),
                                         options);
    expectSoundAndGood(refined, 0.1);
    EXPECT_EQ(refined.check.eulerCharacteristic(), 0);
    EXPECT_NEAR(areaOf(refined.mesh), 4.0 * kPi * kPi, 0.1);
}

TEST(SurfaceRefinement, FollowsTheCurvatureOfAPatch)
{
    FaceRefinementOptions options;
    options.criteria.elementsPerTurn = 40.0 * kLongestOverSize;
    const Refined refined = refineFrozen(
        gridFace(std::make_shared<CylinderSurface>(Axes{}, 1.0), {0.0, 0.5 * kPi}, {0.0, 2.0}, 14, 18),
        options);
    expectSound(refined);
    EXPECT_EQ(refined.check.eulerCharacteristic(), 1);
    EXPECT_GT(refined.counts.sizeInsertions, 10u);
    EXPECT_LE(longestEdge(refined.mesh), 1.02 * 2.0 * kPi / 40.0) << "beside the border facets may be left";
}

TEST(SurfaceRefinement, RefinesASplineToItsSag)
{
    FaceRefinementOptions options;
    options.criteria.maxSag = 1e-3;
    const Refined refined = refineFrozen(gridFace(wavySpline(), {0.0, 4.0}, {0.0, 4.0}, 60, 60), options);
    expectSound(refined);
    EXPECT_GT(refined.counts.sizeInsertions, 10u);
    EXPECT_EQ(refined.check.eulerCharacteristic(), 1);
}

/// A ridge along y, three times as high as wide, whose sides are all but upright; the first facets bridge it.
FaceExample bridgedRidge()
{
    BSplineSurfaceData data;
    data.knotsU = {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6};
    data.knotsV = {0, 0, 1, 1};
    data.degreeV = 1;
    const std::array<Vec2, 9> profile = {{{-2.0, 0.0},
                                          {-1.0, 0.0},
                                          {-0.35, 0.0},
                                          {-0.35, 0.5},
                                          {0.0, 2.0},
                                          {0.35, 0.5},
                                          {0.35, 0.0},
                                          {1.0, 0.0},
                                          {2.0, 0.0}}};
    for (const Vec2& p : profile) {
        for (const double y : {0.0, 3.0}) data.poles.push_back({p.x, y, p.y});
    }
    auto ridge = std::make_shared<BSplineSurface>(std::move(data), Interval{0.0, 6.0}, Interval{0.0, 1.0});
    return gridFace(std::move(ridge), {0.0, 6.0}, {0.0, 1.0}, 3, 3);
}

TEST(SurfaceRefinement, GetsIntoAFoldThatFacetsBridge)
{
    const FaceExample example = bridgedRidge();
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    RunContext context;
    Budget budget({.maxVertices = 100'000}, context);
    const FrozenBoundary boundary;
    FaceRefinementOptions options;
    options.splits.floor = 1e-3;
    options.criteria.leastCurvatureSize = 0.05;
    FaceRefiner refiner(*mesh, geometry, boundary, options);
    refiner.queueAll();
    for (int sweep = 0; sweep < 3; ++sweep) {
        EXPECT_EQ(refiner.refine(budget), StopReason::Done);
        refiner.queueGivenUp(context);
    }
    EXPECT_EQ(checkFaceMesh(*mesh, geometry).report.problem, "");
    // Beside the frozen ends facets still bridge the ridge.
    double highest = 0.0;
    for (std::uint32_t i = 0; i < mesh->vertexSlots(); ++i) {
        const Vec3& place = mesh->position(VertexId(i));
        if (place.y > 1.0 && place.y < 2.0) highest = std::max(highest, place.z);
    }
    EXPECT_GT(highest, 0.95 * geometry.at({3.0, 0.5}).position.z);
    EXPECT_GT(refiner.counts().splits.steepStars, 0u);
}

TEST(SurfaceRefinement, EndsAtTheBudgetAndGoesOnFromThere)
{
    RunContext context;
    const FaceExample example = octahedronOnSphere(1.0);
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    const FrozenBoundary boundary;
    FaceRefinementOptions options;
    options.criteria.maxSize = 0.1;
    FaceRefiner refiner(*mesh, geometry, boundary, options);
    refiner.queueAll();
    Budget small({.maxVertices = 100}, context);
    EXPECT_EQ(refiner.refine(small), StopReason::VertexLimit);
    EXPECT_EQ(mesh->vertexCount(), 100u);
    EXPECT_EQ(checkFaceMesh(*mesh, geometry).report.problem, "");
    Budget large({}, context);
    EXPECT_EQ(refiner.refine(large), StopReason::Done);
    EXPECT_LE(longestEdge(*mesh), 0.1 * kLongestOverSize);
}

}  // namespace
}  // namespace mesher::test
