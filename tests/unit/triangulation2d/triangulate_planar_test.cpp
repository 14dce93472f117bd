#include "triangulation2d/triangulate_planar.h"

#include "base/run_context.h"
#include "delaunay/mesh_hash2d.h"
#include "sizing/shape_sizes.h"
#include "sizing/uniform_size.h"
#include "support/planar_builder.h"
#include "support/planar_examples.h"
#include "triangulation2d/planar_check.h"
#include "triangulation2d/small_angle_report2d.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <set>

namespace mesher {
namespace {

using test::PlanarBuilder;

PlanarResult meshOf(const PlanarCurveComplex& complex, const PlanarOptions& options = {})
{
    RunContext context;
    auto result = triangulatePlanar(complex, options, context);
    EXPECT_TRUE(result.hasValue()) << (result ? "" : describe(result.error()));
    if (!result)
        return PlanarResult{.triangulation = {.delaunay = Delaunay2d(),
                                              .boundary = {},
                                              .smallAngles = {},
                                              .subcurveOfEdge = {}},
                            .counts = {},
                            .seconds = {},
                            .refinement = {}};
    const PlanarCheck check = checkPlanar(complex, *result, options);
    for (const std::string& violation : check.violations) ADD_FAILURE() << violation;
    return std::move(*result);
}

Error errorOf(const PlanarCurveComplex& complex, const PlanarOptions& options = {})
{
    RunContext context;
    const auto result = triangulatePlanar(complex, options, context);
    EXPECT_FALSE(result.hasValue());
    return result ? Error{} : result.error();
}

TEST(TriangulatePlanar, isTheSameInEveryRunAndBuild)
{
    const auto hashOf = [](const PlanarCurveComplex& complex, double refinement) {
        PlanarOptions options;
        options.refinement.sizing.refinement = refinement;
        return meshHash2d(meshOf(complex, options).triangulation.mesh());
    };
    EXPECT_EQ(hashOf(test::annulus(), 5.0), hashOf(test::annulus(), 5.0));
    // Pinned, so that Debug and Release are compared with each other.
    EXPECT_EQ(hashOf(test::unitSquare(), 20.0), 9806702972308899591u);
    EXPECT_EQ(hashOf(test::smallAngleFan(), 1.0), 2727695792393791609u);
}

/// Fig. 2.8: R makes the boundary dense, G the interior.
TEST(TriangulatePlanar, refinesTheBoundaryWithRAndTheInteriorWithG)
{
    const auto countsWith = [](double refinement, double grading) {
        PlanarOptions options;
        options.refinement.sizing.refinement = refinement;
        options.refinement.sizing.grading = grading;
        return meshOf(test::annulus(), options).counts;
    };
    const PlanarCounts coarse = countsWith(1.0, 1.0);
    const PlanarCounts dense = countsWith(10.0, 1.0);
    const PlanarCounts uniform = countsWith(10.0, 10.0);
    RecordProperty("coarse_vertices", static_cast<int>(coarse.vertices));
    RecordProperty("r10_vertices", static_cast<int>(dense.vertices));
    RecordProperty("r10_g10_vertices", static_cast<int>(uniform.vertices));
    EXPECT_LE(coarse.vertices, 20u);
    EXPECT_GT(dense.boundaryEdges, 4 * coarse.boundaryEdges);
    EXPECT_LT(uniform.boundaryEdges, 2 * dense.boundaryEdges);
    EXPECT_GT(uniform.vertices - uniform.boundaryEdges, 2 * (dense.vertices - dense.boundaryEdges));
}

TEST(TriangulatePlanar, needsFewerVerticesWithALooserBoundOnTheTurning)
{
    PlanarOptions options;
    options.refinement.sizing.usesLocalFeatureSize = false;
    const std::size_t loose = meshOf(test::threeElementAirfoil(), options).counts.vertices;
    options.sampling.maxVariation = 30.0;
    const std::size_t tight = meshOf(test::threeElementAirfoil(), options).counts.vertices;
    RecordProperty("vertices_at_90_degrees", static_cast<int>(loose));
    RecordProperty("vertices_at_30_degrees", static_cast<int>(tight));
    EXPECT_LE(static_cast<double>(loose), 0.75 * static_cast<double>(tight));
}

TEST(TriangulatePlanar, keepsToAUniformSize)
{
    const UniformSize size(0.05);
    PlanarOptions options;
    options.refinement.sizing.field = &size;
    const PlanarResult result = meshOf(test::annulus(), options);
    const Triangulation2d& mesh = result.triangulation.mesh();
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        if (!mesh.isAlive(TriangleId(i)) || !result.triangulation.isMeshed(TriangleId(i))) continue;
        for (unsigned k = 0; k < 3; ++k) {
            const Triangle2d& record = mesh.triangle(TriangleId(i));
            const double edge = length(mesh.position(record.v[k]) - mesh.position(record.v[nextCorner(k)]));
            EXPECT_LT(edge, std::sqrt(2.0) * 0.05);
            EXPECT_GT(edge, 0.3 * 0.05);
        }
    }
}

TEST(TriangulatePlanar, findsASmallPlaceInTheMiddle)
{
    DistanceProfile profile;
    profile.size = 0.002;
    const BallSize size({0.37, 0.61, 0.0}, 0.01, profile);
    PlanarOptions options;
    options.refinement.sizing.field = &size;
    const PlanarResult result = meshOf(test::unitSquare(), options);
    const Triangulation2d& mesh = result.triangulation.mesh();
    const TriangleId t = result.triangulation.delaunay.locate({0.37, 0.61}).triangle();
    const Triangle2d& record = mesh.triangle(t);
    EXPECT_LT(length(mesh.position(record.v[0]) - mesh.position(record.v[1])), 0.003);
    EXPECT_LT(result.counts.triangles, 5000u);
}

TEST(TriangulatePlanar, estimatesItsSizeBeforehand)
{
    for (const PlanarCurveComplex& complex : {test::annulus(), test::unitSquare(), test::splineCavity()}) {
        const UniformSize size(0.02);
        PlanarOptions options;
        options.refinement.sizing.field = &size;
        const auto counts = meshOf(complex, options).counts;
        const auto count = static_cast<double>(counts.triangles);
        EXPECT_NEAR(counts.expectedTriangles, count, 0.25 * count);
    }
}

TEST(TriangulatePlanar, meetsHigherAndLowerBoundsOnTheAngles)
{
    for (const double bound : {0.0, 15.0, 25.0, 32.0}) {
        PlanarOptions options;
        options.refinement.minAngle = bound;
        options.limits.maxVertices = 100000;
        const PlanarCurveComplex complex = test::threeElementAirfoil();
        const PlanarResult result = meshOf(complex, options);
        EXPECT_EQ(result.stopReason, StopReason::Done) << bound;
        EXPECT_GE(checkPlanar(complex, result, options).angles.smallest, bound - 1e-6);
    }
}

TEST(TriangulatePlanar, stopsAtItsLimitsWithAValidTriangulation)
{
    const UniformSize size(0.001);
    PlanarOptions options;
    options.refinement.sizing.field = &size;
    options.limits.maxElements = 5000;
    const PlanarResult result = meshOf(test::annulus(), options);
    EXPECT_EQ(result.stopReason, StopReason::ElementLimit);
    EXPECT_GE(result.counts.triangles, 5000u);
    EXPECT_LE(result.counts.triangles, 5010u);
    EXPECT_FALSE(result.refinement.left.empty());
    EXPECT_EQ(result.refinement.left.front().reason, LeftReason2d::Unfinished);
}

TEST(TriangulatePlanar, endsWhenItIsCancelled)
{
    const UniformSize size(0.002);
    PlanarOptions options;
    options.refinement.sizing.field = &size;
    RunSettings settings;
    int calls = 0;
    settings.progress = [&](std::string_view, double) { return ++calls < 3; };
    RunContext context(settings);
    const auto result = triangulatePlanar(test::annulus(), options, context);
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->stopReason, StopReason::Cancelled);
    EXPECT_LT(result->counts.triangles, 50000u);
}

/// Degrees between the directions from a place to the ends of a triangle's shortest edge.
double shortestEdgeSeenFrom(Vec2 place, const PlanarResult& result, TriangleId t)
{
    const Triangulation2d& mesh = result.triangulation.mesh();
    double shortest = std::numeric_limits<double>::infinity();
    double angle = 0.0;
    for (unsigned k = 0; k < 3; ++k) {
        const Vec2 a = mesh.position(mesh.triangle(t).v[k]);
        const Vec2 b = mesh.position(mesh.triangle(t).v[nextCorner(k)]);
        if (length(b - a) >= shortest) continue;
        shortest = length(b - a);
        angle = std::abs(std::atan2(cross(a - place, b - place), dot(a - place, b - place)));
    }
    return angle * 180.0 / std::numbers::pi;
}

TEST(TriangulatePlanar, listsTheTrianglesLeftBesideSmallAngles)
{
    const PlanarResult result = meshOf(test::smallAngleFan());
    ASSERT_FALSE(result.refinement.left.empty());
    std::set<double> listed;
    for (const LeftTriangle2d& left : result.refinement.left) {
        ASSERT_EQ(left.reason, LeftReason2d::SmallInputAngle);
        EXPECT_LT(left.smallestAngle, 30.0);
        EXPECT_LT(left.largestAngle, 137.0);
        const SmallAngleComplex& complex = result.triangulation.smallAngles.complexes[left.smallAngle];
        const double degrees = complex.angles[left.inputAngle].degrees;
        listed.insert(std::round(degrees * 10.0) / 10.0);
        // The curves bend a little, so that what is seen from the apex is not quite the angle at it.
        EXPECT_NEAR(degrees, shortestEdgeSeenFrom({0.0, 0.0}, result, left.triangle), 0.15);
    }
    EXPECT_EQ(listed, (std::set<double>{0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 30.0, 45.0}));
    std::size_t reported = 0;
    for (const TrianglesBesideAngle2d& beside : trianglesBesideSmallAngles(result)) {
        EXPECT_EQ(listed.erase(std::round(beside.angle.degrees * 10.0) / 10.0), 1u);
        EXPECT_LT(beside.largestAngle, 137.0);
        EXPECT_EQ(beside.apex, (Vec2{0.0, 0.0}));
        reported += beside.triangles;
    }
    EXPECT_TRUE(listed.empty());
    EXPECT_EQ(reported, result.refinement.left.size());
}

/// A square with two holes, circles that touch each other from outside.
PlanarCurveComplex touchingHoles(double first, double second, double turn)
{
    PlanarBuilder builder;
    const Vec2 corners[] = {{-0.75, -0.75}, {0.75, -0.75}, {0.75, 0.75}, {-0.75, 0.75}};
    builder.polygon(corners);
    const PccPointId p = builder.point({0.0, 0.0});
    const Vec2 direction{std::cos(turn), std::sin(turn)};
    builder.arc(p, p, first * direction, 2.0 * std::numbers::pi, {0, 1});
    builder.arc(p, p, -second * direction, 2.0 * std::numbers::pi, {0, 1});
    return builder.build();
}

/// Beside a cusp the triangles left alone lie between chords that are no mirror images, and could be wider than between lines.
TEST(TriangulatePlanar, leavesNoWideTriangleBesideACusp)
{
    PlanarOptions options;
    options.refinement.sizing.usesLocalFeatureSize = false;
    for (const double radius : {0.18, 0.15, 0.12, 0.0892, 0.07, 0.0396, 0.02}) {
        const PlanarCurveComplex complex = touchingHoles(0.2, radius, 2.0);
        const PlanarResult result = meshOf(complex, options);
        EXPECT_LE(checkPlanar(complex, result, options).angles.largest, 137.0) << radius;
        EXPECT_LT(result.counts.triangles, 1000u) << radius;
    }
}

/// The annulus in a plane anywhere in space, and at any scale.
PlanarCurveComplex annulusAt(double scale)
{
    PlanarBuilder builder;
    builder.circle({0.0, 0.0}, 2.0 * scale);
    builder.circle({0.0, 0.0}, 1.0 * scale, {0, 1});
    return builder.build();
}

TEST(TriangulatePlanar, worksAtExtremeScales)
{
    for (const double scale : {1e-40, 1e-6, 1e6, 1e60}) {
        PlanarOptions options;
        options.refinement.sizing.refinement = 3.0;
        const PlanarResult result = meshOf(annulusAt(scale), options);
        EXPECT_GT(result.counts.triangles, 50u) << scale;
        EXPECT_LT(result.counts.triangles, 1000u) << scale;
    }
}

TEST(TriangulatePlanar, meshesEmbeddedCurvesAndPoints)
{
    PlanarBuilder builder;
    const Vec2 corners[] = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
    builder.polygon(corners);
    builder.line(builder.point({1.0, 1.0}), builder.point({2.0, 1.5}), {1, 1});
    const PccPointId p = builder.embed({3.0, 2.0}, 1);
    const PlanarResult result = meshOf(builder.build());
    const Triangulation2d& mesh = result.triangulation.mesh();
    EXPECT_EQ(mesh.position(result.triangulation.boundary.vertices[BoundaryVertexId(p.value)].vertex),
              (Vec2{3.0, 2.0}));
}

TEST(TriangulatePlanar, refusesBadInput)
{
    EXPECT_EQ(errorOf({}).code, ErrorCode::DegenerateInput);

    PlanarBuilder open;
    const PccPointId a = open.point({0.0, 0.0});
    const PccPointId b = open.point({1.0, 0.0});
    const PccPointId c = open.point({0.0, 1.0});
    open.line(a, b);
    open.line(b, c);
    EXPECT_EQ(errorOf(open.build()).code, ErrorCode::InvalidArgument);

    PlanarBuilder flat;
    flat.line(flat.point({0.0, 0.0}), flat.point({1.0, 0.0}), {0, 0});
    EXPECT_EQ(errorOf(flat.build()).code, ErrorCode::DegenerateInput);

    PlanarBuilder twice;
    const Vec2 corners[] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
    twice.polygon(corners);
    twice.embed({0.0, 0.0}, 1);
    EXPECT_EQ(errorOf(twice.build()).code, ErrorCode::DuplicatePoint);

    PlanarCurveComplex infinite = test::unitSquare();
    infinite.points[2].position.x = std::numeric_limits<double>::infinity();
    EXPECT_EQ(errorOf(infinite).code, ErrorCode::NonFinitePoint);

    PlanarCurveComplex torn = test::unitSquare();
    torn.points[2].position = torn.points[2].spacePosition.x > 0.0 ? Vec2{1.5, 1.5} : Vec2{};
    EXPECT_EQ(errorOf(torn).code, ErrorCode::InvalidArgument);
}

TEST(TriangulatePlanar, refusesOptionsOutOfRange)
{
    PlanarOptions options;
    options.refinement.minAngle = 50.0;
    EXPECT_EQ(errorOf(test::unitSquare(), options).code, ErrorCode::InvalidArgument);
    options = {};
    options.sampling.maxVariation = 10.0;
    EXPECT_EQ(errorOf(test::unitSquare(), options).code, ErrorCode::InvalidArgument);
    options = {};
    options.refinement.sizing.refinement = std::nan("");
    EXPECT_EQ(errorOf(test::unitSquare(), options).code, ErrorCode::InvalidArgument);
    options = {};
    options.refinement.sizing.grading = 0.0;
    EXPECT_EQ(errorOf(test::unitSquare(), options).code, ErrorCode::InvalidArgument);
}

TEST(PlanarCheck, seesWhatIsWrong)
{
    const PlanarCurveComplex complex = test::annulus();
    const PlanarResult result = meshOf(complex);
    PlanarOptions strict;
    strict.refinement.minAngle = 40.0;
    EXPECT_FALSE(checkPlanar(complex, result, strict).isClean());

    PlanarCurveComplex swapped = complex;
    std::swap(swapped.curves[0].left, swapped.curves[0].right);
    EXPECT_FALSE(checkPlanar(swapped, result, {}).isClean());

    PlanarBuilder other;
    other.circle({0.0, 0.0}, 2.0);
    other.circle({0.0, 0.0}, 1.0000001, {0, 1});
    EXPECT_FALSE(checkPlanar(other.build(), result, {}).isClean());
}

TEST(PlanarCheck, knowsAreasAndEulerCharacteristics)
{
    const PlanarCurveComplex complex = test::annulus();
    const PlanarCheck check = checkPlanar(complex, meshOf(complex), {});
    ASSERT_EQ(check.regions.size(), 1u);
    EXPECT_NEAR(check.regions[0].curveArea, 3.0 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(check.regions[0].area + check.regions[0].segmentArea, check.regions[0].curveArea, 1e-12);
    EXPECT_EQ(check.regions[0].eulerCharacteristic, 0);
}

}  // namespace
}  // namespace mesher
