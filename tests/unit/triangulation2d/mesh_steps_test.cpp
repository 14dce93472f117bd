#include "base/random.h"
#include "base/run_context.h"
#include "delaunay/delaunay_check2d.h"
#include "support/planar_builder.h"
#include "support/planar_examples.h"
#include "triangulation2d/length_scale2d.h"
#include "triangulation2d/straight_walk2d.h"
#include "triangulation2d/triangle_shape2d.h"
#include "triangulation2d/triangulate_planar.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

namespace mesher {
namespace {

PlanarResult initialOf(const PlanarCurveComplex& complex, PlanarSizing sizing = {})
{
    PlanarOptions options;
    options.isRefined = false;
    options.refinement.sizing = sizing;
    RunContext context;
    auto result = triangulatePlanar(complex, options, context);
    EXPECT_TRUE(result.hasValue());
    return std::move(*result);
}

using ScaleByPlace = std::map<std::pair<double, double>, double>;

ScaleByPlace scalesOf(const PlanarResult& result)
{
    ScaleByPlace scales;
    const Triangulation2d& mesh = result.triangulation.mesh();
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        const Vec2 p = mesh.position(VertexId(i));
        scales[{p.x, p.y}] = mesh.lengthScale(VertexId(i));
    }
    return scales;
}

/// The same complex with its points and curves in another order.
PlanarCurveComplex shuffled(const PlanarCurveComplex& complex, std::uint64_t seed)
{
    Random random(seed);
    PlanarCurveComplex result = complex;
    std::vector<std::uint32_t> order(complex.points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    for (std::uint32_t i = 0; i < order.size(); ++i) result.points[order[i]] = complex.points[i];
    for (PccCurve& curve : result.curves) {
        curve.first = PccPointId(order[curve.first.value]);
        curve.last = PccPointId(order[curve.last.value]);
    }
    std::shuffle(result.curves.begin(), result.curves.end(), random);
    return result;
}

/// Places in the order in which they were inserted.
std::vector<Vec2> placesInOrder(const PlanarResult& result)
{
    std::vector<Vec2> places;
    for (std::uint32_t i = 0; i < result.triangulation.mesh().vertexSlots(); ++i)
        places.push_back(result.triangulation.mesh().position(VertexId(i)));
    return places;
}

/// A plate with holes of many sizes: more vertices than are inserted in one round along a Hilbert curve, so that the order
/// of insertion depends on the order of the input.
PlanarCurveComplex plateWithHoles()
{
    constexpr int kRows = 48;
    test::PlanarBuilder builder;
    const Vec2 corners[] = {{0.0, 0.0}, {kRows, 0.0}, {kRows, kRows}, {0.0, kRows}};
    builder.polygon(corners);
    Random random(3);
    for (int i = 0; i < kRows * kRows; ++i) {
        const Vec2 centre{i % kRows + 0.5, std::floor(i / kRows) + 0.5};
        builder.circle(centre, random.between(0.01, 0.4), {0, 1}, false, random.between(0.0, 6.0));
    }
    return builder.build();
}

TEST(LengthScales, dependOnNoOrderOfInsertion)
{
    // The feature size grows no faster than the distance: only a slower growth has anything to grade.
    PlanarSizing slowlyGrowing;
    slowlyGrowing.grading = 5.0;
    const PlanarCurveComplex complex = plateWithHoles();
    const PlanarResult first = initialOf(complex, slowlyGrowing);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const PlanarResult other = initialOf(shuffled(complex, seed), slowlyGrowing);
        EXPECT_TRUE(placesInOrder(other) != placesInOrder(first)) << "seed " << seed;
        EXPECT_TRUE(scalesOf(other) == scalesOf(first)) << "seed " << seed;
    }
}

TEST(LengthScales, dependOnNoOrderOfTheInput)
{
    PlanarSizing slowlyGrowing;
    slowlyGrowing.grading = 5.0;
    for (const PlanarCurveComplex& complex :
         {test::splineCavity(), test::smallAngleFan(), test::threeElementAirfoil()}) {
        const ScaleByPlace expected = scalesOf(initialOf(complex, slowlyGrowing));
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            EXPECT_EQ(scalesOf(initialOf(shuffled(complex, seed), slowlyGrowing)), expected)
                << "seed " << seed;
        }
    }
}

TEST(LengthScales, areTheFeatureSizeOverRAndGraded)
{
    PlanarSizing sizing;
    sizing.refinement = 3.0;
    sizing.grading = 2.0;
    const PlanarCurveComplex complex = test::splineCavity();
    const PlanarResult result = initialOf(complex, sizing);
    const auto domain = PlanarDomain::make(complex);
    const Triangulation2d& mesh = result.triangulation.mesh();
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        const VertexId v(i);
        EXPECT_LE(mesh.lengthScale(v), localFeatureSize(*domain, result.triangulation, v) / 3.0);
        mesh.forEachTriangleAround(v, [&](EdgeLink opposite) {
            if (!result.triangulation.isMeshed(opposite.triangle())) return true;
            const VertexId w = mesh.edgeFrom(opposite);
            EXPECT_LE(mesh.lengthScale(v), mesh.lengthScale(w) + length(mesh.position(w) - mesh.position(v)) /
                                                                     2.0 * (1.0 + 1e-12));
            return true;
        });
    }
}

TEST(LengthScales, knowTheFeatureSizeOfARectangle)
{
    test::PlanarBuilder builder;
    const Vec2 corners[] = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}, {0.0, 1.0}};
    builder.polygon(corners);
    const PlanarCurveComplex complex = builder.build();
    const PlanarResult result = initialOf(complex);
    const auto domain = PlanarDomain::make(complex);
    for (std::uint32_t i = 0; i < result.triangulation.mesh().vertexSlots(); ++i) {
        EXPECT_NEAR(localFeatureSize(*domain, result.triangulation, VertexId(i)), 1.0, 1e-12);
    }
}

TEST(StraightWalk, findsWhatItSeesAndStopsAtConstraints)
{
    PlanarOptions options;
    options.refinement.sizing.refinement = 4.0;
    RunContext context;
    const auto result = triangulatePlanar(test::annulus(), options, context);
    ASSERT_TRUE(result.hasValue());
    const Triangulation2d& mesh = result->triangulation.mesh();
    Random random(9);
    int found = 0;
    int blocked = 0;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const TriangleId t(i);
        if (!mesh.isAlive(t) || !result->triangulation.isMeshed(t)) continue;
        const double angle = random.between(0.0, 2.0 * std::numbers::pi);
        const Vec2 target = random.between(1.1, 1.9) * Vec2{std::cos(angle), std::sin(angle)};
        const StraightWalk2d walk = walkStraight(mesh, {}, t, target);
        ASSERT_NE(walk.outcome, StraightWalk2d::Outcome::Lost);
        if (walk.outcome == StraightWalk2d::Outcome::Blocked) {
            EXPECT_TRUE(mesh.isConstrained(walk.blocker));
            ++blocked;
            continue;
        }
        ++found;
        const Location2d expected = result->triangulation.delaunay.locate(target);
        EXPECT_EQ(walk.location.kind, expected.kind);
        EXPECT_EQ(walk.location.triangle(), expected.triangle());
    }
    EXPECT_GT(found, 20);
    EXPECT_GT(blocked, 20);
}

TEST(TriangleShape, knowsRadiusShortestEdgeAndCentre)
{
    const Vec2 a{0.0, 0.0};
    const Vec2 b{3.0, 0.0};
    const Vec2 c{0.0, 4.0};
    const TriangleShape2d shape = TriangleShape2d::of(a, b, c);
    EXPECT_DOUBLE_EQ(shape.squaredRadius, 6.25);
    EXPECT_DOUBLE_EQ(shape.squaredShortest, 9.0);
    EXPECT_EQ(shape.shortestEdge, 2u);
    EXPECT_DOUBLE_EQ(shape.doubleArea, 12.0);
    EXPECT_EQ(circumcenter(a, b, c), (Vec2{1.5, 2.0}));
    // r / l = 1 / (2 sin a) of the smallest angle.
    EXPECT_NEAR(std::sqrt(shape.squaredRatio()), 1.0 / (2.0 * std::sin(std::atan2(3.0, 4.0))), 1e-15);
}

TEST(ConstrainedDelaunay, isWhatTheEnrichedBoundaryAsksFor)
{
    for (const test::PlanarExample& example : test::allPlanarExamples()) {
        const PlanarResult result = initialOf(example.complex);
        EXPECT_TRUE(checkDelaunay2d(result.triangulation.mesh()).isValid()) << example.name;
        std::size_t triangles = 0;
        for (std::uint32_t i = 0; i < result.triangulation.mesh().triangleSlots(); ++i) {
            if (result.triangulation.isMeshed(TriangleId(i))) ++triangles;
        }
        EXPECT_EQ(triangles, result.counts.initialTriangles);
    }
}

}  // namespace
}  // namespace mesher
