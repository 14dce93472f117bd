#include "brep/analytic/bspline_curve.h"
#include "brep/analytic/conic_curves.h"
#include "brep/analytic/line_curve.h"
#include "brep/analytic/parameter_curves.h"
#include "brep/analytic/round_surfaces.h"
#include "brep/analytic/spline_interpolation.h"
#include "support/curve_contract.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace mesher {

namespace {

constexpr double kPi = std::numbers::pi;

const Axes kTilted{{1.0, -2.0, 0.5}, {0.6, 0.8, 0.0}, {0.0, 0.0, 1.0}, {0.8, -0.6, 0.0}};

void expectContract(const Curve& curve, Interval part)
{
    for (const std::string& line : test::findBrokenPromises(curve, part, 10.0)) ADD_FAILURE() << line;
}

std::vector<Vec3> randomPoles(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec3> poles;
    for (std::size_t i = 0; i < count; ++i) {
        poles.push_back({static_cast<double>(i) + random.between(-0.5, 0.5), random.between(-2.0, 2.0),
                         random.between(-1.0, 1.0)});
    }
    return poles;
}

BSplineData clampedSpline(std::size_t degree, std::vector<double> interior, std::uint64_t seed)
{
    BSplineData data;
    data.degree = degree;
    data.knots.assign(degree + 1, 0.0);
    data.knots.insert(data.knots.end(), interior.begin(), interior.end());
    data.knots.insert(data.knots.end(), degree + 1, 1.0);
    data.poles = randomPoles(data.knots.size() - degree - 1, seed);
    return data;
}

}  // namespace

TEST(AnalyticCurves, SplinesFindTheirOwnPointsWhereTheyTurnSharply)
{
    using Poles = std::vector<Vec3>;
    const std::array<Poles, 3> examples = {
        Poles{{0.75, 0.65, 0.0}, {0.9, 0.75, 0.0}, {0.25, 0.05, 0.0}, {0.25, 0.0, 0.0}},
        Poles{{0.95, 0.0, 0.0}, {0.1, 0.65, 0.0}, {0.05, 0.8, 0.0}, {0.8, 0.15, 0.0}},
        Poles{{0.15, 0.2, 0.0}, {0.95, 0.85, 0.0}, {0.65, 0.45, 0.0}, {0.0, 0.15, 0.0}}};
    for (const Poles& poles : examples) {
        BSplineData data;
        data.degree = 3;
        data.knots = {0, 0, 0, 0, 1, 1, 1, 1};
        data.poles = poles;
        const auto curve = BSplineCurve::make(std::move(data));
        ASSERT_TRUE(curve.hasValue());
        for (int i = 0; i <= 1000; ++i) {
            const Vec3 point = (*curve)->position(i / 1000.0);
            EXPECT_LT((*curve)->project(point, {0.0, 1.0}, {}).distance, 1e-9) << i;
        }
    }
}

TEST(AnalyticCurves, LineAndConicsKeepTheContract)
{
    expectContract(LineCurve::between({1.0, 2.0, 3.0}, {-2.0, 0.0, 5.0}), {0.0, std::sqrt(17.0)});
    expectContract(LineCurve({1.0, 2.0, 3.0}, {0.0, 0.0, 4.0}, {-1.0, 2.0}), {-1.0, 2.0});
    expectContract(CircleCurve(kTilted, 2.5, {0.0, 2.0 * kPi}), {0.0, 2.0 * kPi});
    expectContract(CircleCurve(kTilted, 2.5, {-1.0, 2.0}), {-1.0, 2.0});
    expectContract(CircleCurve(kTilted, 2.5, {5.0, 7.0}), {5.0, 7.0});
    for (const double b : {3.0, 1.0, 0.1, 4.0}) {
        expectContract(EllipseCurve(kTilted, 3.0, b, {0.0, 2.0 * kPi}), {0.0, 2.0 * kPi});
        expectContract(EllipseCurve(kTilted, 3.0, b, {5.0, 8.0}), {5.0, 8.0});
    }
}

TEST(AnalyticCurves, SplinesOfAllDegreesKeepTheContract)
{
    for (std::size_t degree = 1; degree <= 9; ++degree) {
        SCOPED_TRACE(degree);
        const auto curve = BSplineCurve::make(clampedSpline(degree, {0.2, 0.45, 0.45, 0.8}, degree));
        if (degree == 1) {
            EXPECT_FALSE(curve);  // a double knot tears a polyline apart
            continue;
        }
        ASSERT_TRUE(curve);
        expectContract(**curve, (*curve)->range());
        expectContract(**curve, {0.1, 0.7});
    }
}

TEST(AnalyticCurves, PolylineTurnsAtItsCorners)
{
    BSplineData data;
    data.degree = 1;
    data.poles = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {2.0, 2.0, 0.0}};
    data.knots = {0.0, 0.0, 1.0, 2.0, 3.0, 3.0};
    const auto curve = BSplineCurve::make(data);
    ASSERT_TRUE(curve);
    EXPECT_EQ((*curve)->breaks().size(), 2u);
    expectContract(**curve, (*curve)->range());
}

TEST(AnalyticCurves, RationalQuadraticIsACircle)
{
    const double h = std::sqrt(0.5);
    const auto arc =
        BSplineCurve::makeBezier({{1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}, {1.0, h, 1.0});
    ASSERT_TRUE(arc);
    EXPECT_EQ((*arc)->kind(), CurveKind::Bezier);
    for (int i = 0; i <= 20; ++i) {
        const CurvePoint p = (*arc)->evaluate(i / 20.0);
        EXPECT_NEAR(length(p.position), 1.0, 1e-15);
        EXPECT_NEAR(length(cross(p.d1, p.d2)) / std::pow(length(p.d1), 3.0), 1.0, 1e-13);
    }
    expectContract(**arc, (*arc)->range());
}

TEST(AnalyticCurves, InterpolatingSplinePassesItsPointsTwiceDifferentiable)
{
    const std::vector<Vec3> points = randomPoles(12, 5);
    const auto curve = interpolateCubic(points, {Vec3{0.0, 1.0, 0.0}, {}});
    ASSERT_TRUE(curve);
    EXPECT_TRUE((*curve)->breaks().empty());
    const std::vector<double>& knots = (*curve)->data().knots;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LT(length((*curve)->position(knots[i + 3]) - points[i]), 1e-13);
    }
    EXPECT_LT(length((*curve)->evaluate(0.0).d1 - Vec3{0.0, 1.0, 0.0}), 1e-13);
    EXPECT_LT(length((*curve)->evaluate(knots.back()).d2), 1e-11);
    for (std::size_t i = 4; i + 4 < knots.size(); ++i) {
        const CurvePoint before = (*curve)->evaluate(std::nextafter(knots[i], 0.0));
        EXPECT_LT(length(before.d2 - (*curve)->evaluate(knots[i]).d2), 1e-10);
    }
    expectContract(**curve, (*curve)->range());
}

TEST(AnalyticCurves, BadSplinesAreRefusedWithAReason)
{
    BSplineData good = clampedSpline(3, {0.5}, 1);
    ASSERT_TRUE(BSplineCurve::make(good));
    auto bad = good;
    bad.poles.pop_back();
    EXPECT_FALSE(BSplineCurve::make(bad));
    bad = good;
    bad.weights.assign(bad.poles.size(), 1.0);
    EXPECT_TRUE(BSplineCurve::make(bad));
    bad.weights[1] = 0.0;
    EXPECT_FALSE(BSplineCurve::make(bad));
    bad = good;
    bad.knots[4] = 2.0;
    EXPECT_FALSE(BSplineCurve::make(bad));
    bad = good;
    bad.poles[0].x = std::nan("");
    EXPECT_FALSE(BSplineCurve::make(bad));
    bad = good;
    bad.degree = 26;
    EXPECT_FALSE(BSplineCurve::make(bad));
    const Vec3 p{1.0, 1.0, 0.0};
    EXPECT_FALSE(interpolateCubic(std::vector<Vec3>{p, {}}));
    EXPECT_FALSE(interpolateCubic(std::vector<Vec3>{p, p, {}}));
}

// A meridian that misses the pole by rounding: a point there projects to any longitude.
TEST(ProjectedParameterCurve, KeepsTheRoughParameterWhereItMakesNoDifference)
{
    constexpr double kLongitude = 0.7, kOff = 1e-5;
    const Vec3 along{std::cos(kLongitude), std::sin(kLongitude), 0.0};
    const Vec3 beside{-along.y, along.x, 0.0};
    const Axes meridian{1e-13 * beside, along, {0.0, 0.0, 1.0}, -1.0 * beside};
    for (const double ahead : {0.0, 1e-3}) {
        const ProjectedParameterCurve curve(
            std::make_unique<CircleCurve>(meridian, 2.0, Interval{0.0, 0.5 * kPi}),
            std::make_unique<SphereSurface>(Axes{}, 2.0),
            std::make_unique<LineParameterCurve>(Vec2{kLongitude + kOff, -ahead}, Vec2{0.0, 1.0}));
        EXPECT_NEAR(curve.position(0.5 * kPi).x, kLongitude + kOff, 1e-12);
        EXPECT_NEAR(curve.position(0.5 * kPi).y, 0.5 * kPi, 1e-12);
        EXPECT_NEAR(curve.position(0.4).x, kLongitude, 1e-12);
        EXPECT_NEAR(curve.position(0.4).y, 0.4, 1e-12);
    }
}

}  // namespace mesher
