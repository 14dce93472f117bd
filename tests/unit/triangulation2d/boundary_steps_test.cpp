#include "base/run_context.h"
#include "support/planar_builder.h"
#include "support/planar_examples.h"
#include "support/random_domains.h"
#include "triangulation2d/boundary_enrichment.h"
#include "triangulation2d/boundary_intersection.h"
#include "triangulation2d/curve_sampling.h"
#include "triangulation2d/encroachment2d.h"
#include "triangulation2d/small_angles2d.h"
#include "triangulation2d/visibility2d.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace mesher {
namespace {

using test::PlanarBuilder;
constexpr double kPi = std::numbers::pi;
constexpr PlanarBuilder::Sides kEmbedded{1, 1};

/// A complex with the steps done on it so far; the complex stays where the domain refers to it.
struct Steps
{
    PlanarCurveComplex complex;
    PlanarDomain domain;
    Boundary boundary;

    Steps(PlanarCurveComplex made, double maxVariation)
        : complex(std::move(made)),
          domain(*PlanarDomain::make(complex)),
          boundary(*sampleCurves(domain, {maxVariation}))
    {
    }

    [[nodiscard]] std::vector<SubcurveId> alive() const
    {
        std::vector<SubcurveId> result;
        for (std::uint32_t i = 0; i < boundary.subcurves.size(); ++i) {
            if (boundary.subcurves[SubcurveId(i)].isAlive) result.push_back(SubcurveId(i));
        }
        return result;
    }
};

TEST(CurveSampling, cutsACircleByItsTurning)
{
    for (const auto& [degrees, pieces] :
         {std::pair(90.0, 4u), std::pair(60.0, 6u), std::pair(30.0, 12u), std::pair(89.0, 5u)}) {
        PlanarBuilder builder;
        builder.circle({1.0, 2.0}, 3.0);
        const Steps steps(builder.build(), degrees);
        EXPECT_EQ(steps.alive().size(), pieces) << degrees;
        for (const SubcurveId s : steps.alive()) {
            EXPECT_NEAR(steps.boundary.edgeLength(s), 2.0 * 3.0 * std::sin(kPi / pieces), 1e-12);
        }
    }
}

TEST(CurveSampling, givesClosedCurvesThreeSamples)
{
    PlanarBuilder builder;
    // A drop: turns by little more than half a turn.
    const PccPointId p = builder.point({0.0, 0.0});
    const Vec2 controls[] = {{1.0, 0.2}, {1.0, -0.2}};
    builder.bezier(p, controls, p);
    const Steps steps(builder.build(), 90.0);
    EXPECT_GE(steps.alive().size(), 3u);
}

TEST(CurveSampling, makesCornersInsideOfACurveVertices)
{
    PlanarBuilder builder;
    const PccPointId p = builder.point({0.0, 0.0});
    const Vec2 corners[] = {{2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}};
    builder.polyline(p, corners, p);
    const Steps steps(builder.build(), 90.0);
    ASSERT_EQ(steps.alive().size(), 4u);
    for (const Vec2 corner : corners) {
        const bool isVertex =
            std::any_of(steps.boundary.vertices.begin(), steps.boundary.vertices.end(),
                        [&](const BoundaryVertex& v) { return v.position == corner && v.isCorner; });
        EXPECT_TRUE(isVertex) << corner.x << ' ' << corner.y;
    }
}

TEST(CurveSampling, separatesTwoCurvesBetweenTheSamePoints)
{
    PlanarBuilder builder;
    const PccPointId a = builder.point({-1.0, 0.0});
    const PccPointId b = builder.point({1.0, 0.0});
    builder.arc(a, b, {0.0, 1.0}, 0.5 * kPi);
    builder.line(b, a);
    const Steps steps(builder.build(), 90.0);
    EXPECT_EQ(steps.alive().size(), 3u);
}

TEST(CurveSampling, refusesCoincidingLines)
{
    PlanarBuilder builder;
    const PccPointId a = builder.point({-1.0, 0.0});
    const PccPointId b = builder.point({1.0, 0.0});
    builder.line(a, b);
    builder.line(b, a);
    const PlanarCurveComplex complex = builder.build();
    const auto boundary = sampleCurves(*PlanarDomain::make(complex), {});
    ASSERT_FALSE(boundary.hasValue());
    EXPECT_EQ(boundary.error().code, ErrorCode::IntersectingConstraints);
}

/// Lines from the origin at the given angles, embedded in region 1.
PlanarCurveComplex star(const std::vector<double>& degrees, const std::vector<double>& reaches)
{
    PlanarBuilder builder;
    const Vec2 corners[] = {{-3.0, -3.0}, {3.0, -3.0}, {3.0, 3.0}, {-3.0, 3.0}};
    builder.polygon(corners);
    const PccPointId apex = builder.point({0.0, 0.0});
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const double angle = degrees[i] * kPi / 180.0;
        builder.line(apex, builder.point(reaches[i] * Vec2{std::cos(angle), std::sin(angle)}), kEmbedded);
    }
    return builder.build();
}

TEST(SmallAngles, cutsAllCurvesOfAComplexAtOneShell)
{
    Steps steps(star({0.0, 20.0, 70.0}, {1.0, 2.0, 1.3}), 90.0);
    const SmallAngles2d angles = protectSmallAngles(steps.domain, steps.boundary);
    ASSERT_EQ(angles.complexes.size(), 1u);
    EXPECT_EQ(angles.complexes[SmallAngleId(0)].angles.size(), 2u);
    EXPECT_NEAR(angles.complexes[SmallAngleId(0)].smallestAngle(), 20.0, 1e-6);
    // The largest power of two below two thirds of the shortest edge.
    EXPECT_EQ(angles.complexes[SmallAngleId(0)].firstShell, -1);
    EXPECT_EQ(angles.splits, 3u);
    for (const SubcurveId s : steps.alive()) {
        if (steps.boundary.subcurves[s].wedge.isValid()) {
            EXPECT_NEAR(steps.boundary.edgeLength(s), 0.5, 1e-15);
        }
    }
}

TEST(SmallAngles, findsTwoComplexesAtOneApex)
{
    Steps steps(star({0.0, 30.0, 180.0, 225.0}, {1.0, 1.0, 0.25, 0.25}), 90.0);
    const SmallAngles2d angles = protectSmallAngles(steps.domain, steps.boundary);
    ASSERT_EQ(angles.complexes.size(), 2u);
    EXPECT_NE(angles.complexes[SmallAngleId(0)].firstShell, angles.complexes[SmallAngleId(1)].firstShell);
}

TEST(SmallAngles, splitsSubcurvesBetweenTwoApexesFirst)
{
    PlanarBuilder builder;
    const Vec2 corners[] = {{0.0, 0.0}, {4.0, 0.0}, {2.0, 0.3}};
    builder.polygon(corners);
    Steps steps(builder.build(), 90.0);
    const SmallAngles2d angles = protectSmallAngles(steps.domain, steps.boundary);
    EXPECT_EQ(angles.complexes.size(), 2u);
    EXPECT_EQ(angles.unprotected, 0u);
    // The long side is halved, then both halves and the other two sides are cut at shells.
    EXPECT_EQ(angles.splits, 5u);
}

TEST(SmallAngles, leavesUnmeshedWedgesAlone)
{
    PlanarBuilder builder;
    const Vec2 frame[] = {{-5.0, -5.0}, {5.0, -5.0}, {5.0, 5.0}, {-5.0, 5.0}};
    builder.polygon(frame);
    const Vec2 hole[] = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 0.3}};
    builder.polygon(hole, {0, 1});
    Steps steps(builder.build(), 90.0);
    EXPECT_EQ(protectSmallAngles(steps.domain, steps.boundary).complexes.size(), 0u);
}

TEST(SmallAngles, takesTangentCurvesForAnAngleOfZero)
{
    PlanarBuilder builder;
    const PccPointId p = builder.point({0.0, 0.0});
    builder.arc(p, p, {2.0, 0.0}, 2.0 * kPi, {1, 0});
    builder.arc(p, p, {0.5, 0.0}, 2.0 * kPi, {0, 1});
    Steps steps(builder.build(), 90.0);
    const SmallAngles2d angles = protectSmallAngles(steps.domain, steps.boundary);
    ASSERT_EQ(angles.complexes.size(), 2u);
    EXPECT_NEAR(angles.complexes[SmallAngleId(0)].smallestAngle(), 0.0, 1e-6);
    EXPECT_EQ(angles.unprotected, 0u);
}

TEST(Visibility, tellsTheSideOfACurveFromThatOfItsEdge)
{
    PlanarBuilder builder;
    const PccPointId a = builder.point({-1.0, 0.0});
    const PccPointId b = builder.point({1.0, 0.0});
    builder.arc(a, b, {0.0, 1.0}, 0.5 * kPi);
    const PccPointId c = builder.point({0.0, 3.0});
    builder.line(b, c);
    builder.line(c, a);
    const Steps steps(builder.build(), 90.0);
    const SubcurveId arc = steps.alive().front();
    const double sagitta = std::sqrt(2.0) - 1.0;
    EXPECT_EQ(sideOfEdge(steps.boundary, arc, {0.0, -0.2}), CurveSide::Right);
    EXPECT_EQ(sideOfSubcurve(steps.domain, steps.boundary, arc, {0.0, -0.2}), CurveSide::Left);
    EXPECT_EQ(sideOfSubcurve(steps.domain, steps.boundary, arc, {0.0, -sagitta - 1e-9}), CurveSide::Right);
    EXPECT_EQ(sideOfSubcurve(steps.domain, steps.boundary, arc, {0.0, -sagitta + 1e-9}), CurveSide::Left);
    EXPECT_EQ(sideOfSubcurve(steps.domain, steps.boundary, arc, {0.0, 0.2}), CurveSide::Left);
}

TEST(Encroachment, tellsLensesFromCircles)
{
    const Vec2 a{-1.0, 0.0};
    const Vec2 b{1.0, 0.0};
    EXPECT_TRUE(isInDiametralCircle(a, b, {0.0, 0.99}));
    EXPECT_FALSE(isInDiametralCircle(a, b, {0.0, 1.01}));
    const double apex = 1.0 / std::sqrt(3.0);
    EXPECT_TRUE(isInDiametralLens(a, b, {0.0, apex - 1e-6}));
    EXPECT_FALSE(isInDiametralLens(a, b, {0.0, apex + 1e-6}));
    EXPECT_FALSE(isInDiametralLens(a, b, {2.0, 0.0}));
}

/// All pairs, and visibility along many lines of sight: no vertex of the same region's side sees an edge from inside of its circle.
void expectEnriched(const Steps& steps)
{
    const BoundaryIndex index(steps.boundary);
    EXPECT_TRUE(findIntersections(steps.boundary, index).empty());
    Visibility2d visibility(steps.domain, steps.boundary, index);
    for (const SubcurveId s : steps.alive()) {
        const Subcurve& subcurve = steps.boundary.subcurves[s];
        for (std::uint32_t i = 0; i < steps.boundary.vertices.size(); ++i) {
            const BoundaryVertexId v(i);
            if (v == subcurve.first || v == subcurve.last) continue;
            const Vec2 p = steps.boundary.position(v);
            if (!isInDiametralCircle(steps.boundary.from(s), steps.boundary.to(s), p)) continue;
            EXPECT_FALSE(visibility.isVisible(v, s));
            EXPECT_EQ(sideOfEdge(steps.boundary, s, p), sideOfSubcurve(steps.domain, steps.boundary, s, p));
        }
    }
}

TEST(BoundaryEnrichment, leavesNoVisibleVertexInACircle)
{
    RunContext context;
    for (test::PlanarExample& example : test::allPlanarExamples()) {
        Steps steps(std::move(example.complex), 90.0);
        static_cast<void>(protectSmallAngles(steps.domain, steps.boundary));
        Budget budget({}, context);
        const auto enriched = enrichBoundary(steps.domain, steps.boundary, budget);
        ASSERT_TRUE(enriched.hasValue()) << example.name << ' ' << describe(enriched.error());
        SCOPED_TRACE(example.name);
        expectEnriched(steps);
    }
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Steps steps(test::randomDomain(seed).complex, 90.0);
        static_cast<void>(protectSmallAngles(steps.domain, steps.boundary));
        Budget budget({}, context);
        ASSERT_TRUE(enrichBoundary(steps.domain, steps.boundary, budget).hasValue());
        SCOPED_TRACE(seed);
        expectEnriched(steps);
    }
}

TEST(BoundaryEnrichment, refusesCurvesThatCross)
{
    PlanarBuilder builder;
    const Vec2 frame[] = {{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {-2.0, 2.0}};
    builder.polygon(frame);
    builder.line(builder.point({-1.0, 0.0}), builder.point({1.0, 0.1}), kEmbedded);
    builder.circle({0.0, 0.0}, 0.5, {0, 1});
    Steps steps(builder.build(), 90.0);
    RunContext context;
    Budget budget({.maxOperations = 100000}, context);
    const auto enriched = enrichBoundary(steps.domain, steps.boundary, budget);
    ASSERT_FALSE(enriched.hasValue());
    EXPECT_EQ(enriched.error().code, ErrorCode::IntersectingConstraints);
}

TEST(BoundaryEnrichment, stopsAtItsBudget)
{
    Steps steps(test::smallAngleFan(), 90.0);
    RunContext context;
    Budget budget({.maxOperations = 3}, context);
    const auto enriched = enrichBoundary(steps.domain, steps.boundary, budget);
    ASSERT_TRUE(enriched.hasValue());
    EXPECT_EQ(enriched->splits, 3u);
    EXPECT_EQ(budget.stopReason(), StopReason::OperationLimit);
}

TEST(BoundaryIntersection, countsTouchingAsMeetingButNotCommonEnds)
{
    const Vec2 a{0.0, 0.0};
    const Vec2 b{2.0, 0.0};
    EXPECT_TRUE(doSegmentsMeet(a, b, {1.0, -1.0}, {1.0, 1.0}));
    EXPECT_TRUE(doSegmentsCross(a, b, {1.0, -1.0}, {1.0, 1.0}));
    EXPECT_TRUE(doSegmentsMeet(a, b, {1.0, 0.0}, {1.0, 1.0}));
    EXPECT_FALSE(doSegmentsCross(a, b, {1.0, 0.0}, {1.0, 1.0}));
    EXPECT_FALSE(doSegmentsMeet(a, b, b, {3.0, 1.0}));
    EXPECT_TRUE(doSegmentsMeet(a, b, {1.0, 0.0}, {3.0, 0.0}));
    EXPECT_FALSE(doSegmentsMeet(a, b, {3.0, 0.0}, {4.0, 0.0}));
}

}  // namespace
}  // namespace mesher
