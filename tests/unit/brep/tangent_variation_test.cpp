#include "brep/tangent_variation.h"

#include "brep/analytic/bspline_curve.h"
#include "brep/analytic/conic_curves.h"
#include "brep/analytic/line_curve.h"
#include "brep/tangent_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mesher {

namespace {

constexpr double kPi = std::numbers::pi;

std::shared_ptr<const Curve> spline(std::vector<Vec3> poles, std::size_t degree, std::vector<double> knots)
{
    BSplineData data;
    data.degree = degree;
    data.poles = std::move(poles);
    data.knots = std::move(knots);
    return BSplineCurve::make(std::move(data)).value();
}

/// A quarter circle, a line, and a quarter circle back, as one NURBS of unequal speeds.
std::shared_ptr<const Curve> arcLineArc()
{
    const double h = std::sqrt(0.5);
    BSplineData data;
    data.degree = 2;
    data.poles = {{1.0, 0.0, 0.0},  {1.0, 1.0, 0.0},  {0.0, 1.0, 0.0}, {-2.0, 1.0, 0.0},
                  {-4.0, 1.0, 0.0}, {-5.0, 1.0, 0.0}, {-5.0, 0.0, 0.0}};
    data.weights = {1.0, h, 1.0, 1.0, 1.0, h, 1.0};
    data.knots = {0.0, 0.0, 0.0, 1.0, 1.0, 5.0, 5.0, 6.0, 6.0, 6.0};
    return BSplineCurve::make(std::move(data)).value();
}

}  // namespace

TEST(TangentVariation, IsExactOnLinesAndCircles)
{
    const auto line = std::make_shared<LineCurve>(Vec3{}, Vec3{0.0, 3.0, 4.0}, Interval{0.0, 2.0});
    const TangentVariation straight(line, {0.5, 2.0});
    EXPECT_EQ(straight.totalVariation(), 0.0);
    EXPECT_EQ(straight.totalLength(), 7.5);
    EXPECT_EQ(straight.equalSplit(0.5, 1.0), 0.75);
    const auto circle = std::make_shared<CircleCurve>(Axes{}, 2.0, Interval{0.0, 2.0 * kPi});
    const TangentVariation round(circle, {0.0, 2.0 * kPi});
    EXPECT_EQ(round.totalVariation(), 2.0 * kPi);
    EXPECT_EQ(round.arcLength(1.0, 2.0), 2.0);
    EXPECT_EQ(round.equalSplit(1.0, 2.0), 1.5);
    EXPECT_EQ(round.parameterAtVariation(1.0, 0.25), 1.25);
}

TEST(TangentVariation, OfAnEllipseIsAFullTurnAndItsKnownLength)
{
    const auto ellipse = std::make_shared<EllipseCurve>(Axes{}, 2.0, 1.0, Interval{0.0, 2.0 * kPi});
    const TangentVariation turning(ellipse, {0.0, 2.0 * kPi});
    EXPECT_NEAR(turning.totalVariation(), 2.0 * kPi, 1e-11);
    EXPECT_NEAR(turning.totalLength(), 9.688448220547675, 1e-11);
    EXPECT_NEAR(turning.variation(0.0, 1.0), std::atan2(-2.0 * std::sin(1.0), std::cos(1.0)) + kPi, kPi);
    EXPECT_NEAR(turning.variation(0.0, 1.0), std::atan2(std::sin(1.0) * 2.0, std::cos(1.0)), 1e-12);
    EXPECT_NEAR(turning.equalSplit(0.0, kPi), 0.5 * kPi, 1e-12);
}

TEST(TangentVariation, CountsBothTurnsOfAnInflexion)
{
    // y = x^3 - x on [-1, 1]: the slope goes 2, -1, 2.
    const auto cubic = BSplineCurve::makeBezier(
        {{-1.0, 0.0, 0.0}, {-1.0 / 3.0, 4.0 / 3.0, 0.0}, {1.0 / 3.0, -4.0 / 3.0, 0.0}, {1.0, 0.0, 0.0}});
    const TangentVariation turning(cubic.value(), {0.0, 1.0});
    const double half = std::atan(2.0) + std::atan(1.0);
    EXPECT_NEAR(turning.totalVariation(), 2.0 * half, 1e-11);
    EXPECT_NEAR(turning.variation(0.0, 0.5), half, 1e-11);
    EXPECT_NEAR(turning.equalSplit(0.0, 1.0), 0.5, 1e-5);
}

TEST(TangentVariation, SeesACuspAsACorner)
{
    // (t^2, t^3) on [-1, 1].
    const auto cusp = BSplineCurve::makeBezier(
        {{1.0, -1.0, 0.0}, {-1.0 / 3.0, 1.0, 0.0}, {-1.0 / 3.0, -1.0, 0.0}, {1.0, 1.0, 0.0}});
    const double smooth = 2.0 * std::atan(1.5);
    for (const double last : {1.0, 0.9, 0.77}) {
        const TangentVariation turning(cusp.value(), {0.0, last});
        ASSERT_EQ(turning.corners().size(), 1u) << last;
        EXPECT_NEAR(turning.corners()[0].parameter, 0.5, 1e-9);
        EXPECT_NEAR(turning.corners()[0].angle, kPi, 1e-4);
        EXPECT_NEAR(turning.variation(0.0, 0.5 - 1e-9), 0.5 * smooth, 1e-6);
        EXPECT_EQ(turning.equalSplit(0.0, last), turning.corners()[0].parameter);
    }
}

TEST(TangentVariation, SplitsAtACornerThatCarriesTheMiddle)
{
    const auto polyline = spline({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {2.0, 2.0, 0.0}}, 1,
                                 {0.0, 0.0, 1.0, 2.0, 3.0, 3.0});
    const TangentVariation turning(polyline, {0.0, 3.0});
    ASSERT_EQ(turning.corners().size(), 2u);
    EXPECT_NEAR(turning.corners()[0].angle, 0.5 * kPi, 1e-12);
    EXPECT_NEAR(turning.corners()[1].angle, 0.25 * kPi, 1e-12);
    EXPECT_NEAR(turning.totalVariation(), 0.75 * kPi, 1e-12);
    EXPECT_EQ(turning.variation(0.0, 1.0), 0.0);
    EXPECT_EQ(turning.equalSplit(0.0, 3.0), 1.0);
    EXPECT_EQ(turning.equalSplit(1.0, 3.0), 2.0);
    EXPECT_NEAR(turning.equalSplit(2.0, 3.0), 2.5, 1e-12);
    EXPECT_EQ(turning.parameterAtVariation(0.0, 0.51 * kPi), 2.0);
}

TEST(TangentVariation, SplitsAStraightPieceBetweenEqualTurnsInItsMiddle)
{
    const TangentVariation turning(arcLineArc(), {0.0, 6.0});
    EXPECT_TRUE(turning.corners().empty());
    EXPECT_NEAR(turning.totalVariation(), kPi, 1e-10);
    EXPECT_NEAR(turning.totalLength(), kPi + 4.0, 1e-10);
    EXPECT_NEAR(turning.equalSplit(0.0, 6.0), 3.0, 1e-6);
    EXPECT_NEAR(turning.variation(0.0, turning.equalSplit(0.0, 3.0)), 0.25 * kPi, 1e-9);
    EXPECT_NEAR(turning.equalSplit(1.5, 4.5), 3.0, 1e-9);
    EXPECT_NEAR(turning.parameterAtLengthFraction(0.0, 6.0, 0.5), 3.0, 1e-10);
}

TEST(TangentVariation, SplitsBalancedWhereALittleTurnIsBesideAStraightPiece)
{
    const TangentVariation turning(arcLineArc(), {0.0, 6.0});
    // The line is [1, 5]. Nothing is moved that is balanced as it is, or turns much.
    EXPECT_EQ(turning.balancedSplit(0.0, 6.0), turning.equalSplit(0.0, 6.0));
    EXPECT_EQ(turning.balancedSplit(0.2, 0.8), turning.equalSplit(0.2, 0.8));
    EXPECT_EQ(turning.balancedSplit(0.0, 5.0), turning.equalSplit(0.0, 5.0));
    EXPECT_LT(turning.equalSplit(0.9, 5.0), 1.0);
    const double split = turning.balancedSplit(0.9, 5.0);
    EXPECT_NEAR(turning.arcLength(0.9, split), 0.35 * turning.arcLength(0.9, 5.0), 1e-9);
    const double mirrored = turning.balancedSplit(1.0, 5.1);
    EXPECT_NEAR(turning.arcLength(mirrored, 5.1), 0.35 * turning.arcLength(1.0, 5.1), 1e-9);
}

/// Outlines of letters have such ends: each half by turning alone is a fifth of the one before.
TEST(TangentVariation, HalvesDoNotRunToAnEndOfGrowingCurvature)
{
    const TangentVariation turning(
        spline({{0.0, 0.0, 0.0}, {0.002, 0.0004, 0.0}, {1.0, 0.6, 0.0}}, 2, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}),
        {0.0, 1.0});
    EXPECT_LT(turning.totalVariation(), 0.5);
    double byTurning = 1.0, balanced = 1.0;
    for (int i = 0; i < 4; ++i) {
        byTurning = turning.equalSplit(0.0, byTurning);
        balanced = turning.balancedSplit(0.0, balanced);
    }
    EXPECT_LT(turning.arcLength(0.0, byTurning), 2e-3 * turning.totalLength());
    EXPECT_GT(turning.arcLength(0.0, balanced), 0.014 * turning.totalLength());
}

TEST(TangentVariation, SplitsAtACornerHoweverNearAnEnd)
{
    const auto polyline =
        spline({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}}, 1, {0.0, 0.0, 1.0, 2.0, 2.0});
    const TangentVariation turning(polyline, {0.0, 2.0});
    EXPECT_EQ(turning.balancedSplit(0.99, 2.0), 1.0);
}

TEST(TangentVariation, TakesFewCellsAlsoFarFromTheOrigin)
{
    const auto tableAt = [](double place) {
        const Vec3 away{place, -place, 0.3 * place};
        const auto curve = spline({away, away + Vec3{0.3, 0.7, 0.1}, away + Vec3{1.1, -0.4, 0.3},
                                   away + Vec3{1.4, 0.9, 0.0}, away + Vec3{2.0, 0.0, 0.0}},
                                  3, {0.0, 0.0, 0.0, 0.0, 0.6, 1.0, 1.0, 1.0, 1.0});
        return tabulateTangent(*curve, {0.0, 1.0});
    };
    const TangentTable near = tableAt(0.0), far = tableAt(1e6);
    EXPECT_LE(far.cells.size(), near.cells.size());
    EXPECT_NEAR(far.variation, near.variation, 1e-7);
    EXPECT_NEAR(far.length, near.length, 1e-8);
}

TEST(TangentVariation, OfAHelixIsThatOfSpaceCurves)
{
    struct Helix final : Curve
    {
        CurveKind kind() const override { return CurveKind::Other; }
        Interval range() const override { return {0.0, 20.0}; }
        Vec3 position(double t) const override { return {std::cos(t), std::sin(t), 0.5 * t}; }
        CurvePoint evaluate(double t) const override
        {
            return {position(t), {-std::sin(t), std::cos(t), 0.5}, {-std::cos(t), -std::sin(t), 0.0}};
        }
        std::span<const double> breaks() const override { return {}; }
        CurveProjection project(const Vec3&, Interval, std::optional<double>) const override { return {}; }
        std::unique_ptr<Curve> clone() const override { return std::make_unique<Helix>(*this); }
    };
    const TangentVariation turning(std::make_shared<Helix>(), {0.0, 20.0});
    EXPECT_NEAR(turning.totalVariation(), 20.0 / std::sqrt(1.25), 1e-10);
    EXPECT_NEAR(turning.totalLength(), 20.0 * std::sqrt(1.25), 1e-10);
}

TEST(ParameterAtDistance, FindsTheFirstCrossingFromEitherEnd)
{
    const auto circle = std::make_shared<CircleCurve>(Axes{}, 1.0, Interval{0.0, 2.0 * kPi});
    const TangentVariation turning(circle, {0.0, 2.0 * kPi});
    const Vec3 apex{1.0, 0.0, 0.0};
    const auto first = turning.parameterAtDistance(apex, 1.0, {0.0, 2.0 * kPi}, CurveEnd::First);
    ASSERT_TRUE(first.parameter);
    EXPECT_NEAR(*first.parameter, kPi / 3.0, 1e-14);
    EXPECT_TRUE(first.isMonotone);
    const auto last = turning.parameterAtDistance(apex, 1.0, {0.0, 2.0 * kPi}, CurveEnd::Last);
    EXPECT_NEAR(last.parameter.value(), 5.0 * kPi / 3.0, 1e-14);
    const auto none = turning.parameterAtDistance(apex, 2.5, {0.0, 2.0 * kPi}, CurveEnd::First);
    EXPECT_FALSE(none.parameter);
    EXPECT_FALSE(none.isMonotone);
    EXPECT_TRUE(turning.parameterAtDistance(apex, 2.5, {0.0, 3.0}, CurveEnd::First).isMonotone);
}

TEST(ParameterAtDistance, SaysWhenTheCurveComesBackBeforeItLeaves)
{
    const auto hook = spline({{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {1.0, 0.5, 0.0}, {4.0, 1.0, 0.0}}, 1,
                             {0.0, 0.0, 1.0, 2.0, 3.0, 3.0});
    const TangentVariation turning(hook, {0.0, 3.0});
    EXPECT_TRUE(turning.parameterAtDistance({}, 1.9, {0.0, 3.0}, CurveEnd::First).isMonotone);
    EXPECT_NEAR(turning.parameterAtDistance({}, 1.9, {0.0, 3.0}, CurveEnd::First).parameter.value(), 0.95,
                1e-14);
    const auto late = turning.parameterAtDistance({}, 3.0, {0.0, 3.0}, CurveEnd::First);
    EXPECT_FALSE(late.isMonotone);
    ASSERT_TRUE(late.parameter);
    EXPECT_NEAR(length(hook->position(*late.parameter)), 3.0, 1e-13);
}

}  // namespace mesher
