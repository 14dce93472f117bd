#include "pipeline/curve_quadrature.h"

#include "support/planar_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mesher {
namespace {

constexpr Vec3 kUp = {0.0, 0.0, 1.0};

/// An ellipse of half axes 2 and 1.
std::shared_ptr<const Curve> ellipse()
{
    test::PlanarBuilder builder;
    builder.ellipse({0.0, 0.0}, 2.0, 1.0, 0.0);
    return builder.build().curves.front().curve;
}

double lengthBy(const Curve& curve, int order, int pieces)
{
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const Interval part = {1.0 * i / pieces, 1.0 * (i + 1) / pieces};
        for (const CurvedBoundaryPoint& point : gaussPointsOn(curve, part, kUp, order)) sum += point.weight;
    }
    return sum;
}

TEST(CurveQuadrature, LiesOnTheCurveWithItsNormalToTheRight)
{
    const auto curve = ellipse();
    for (int order = 2; order <= 4; ++order) {
        const auto points = gaussPointsOn(*curve, {0.2, 0.9}, kUp, order);
        EXPECT_EQ(points.size(), order == 2 ? 1u : 2u);
        for (const CurvedBoundaryPoint& point : points) {
            const Vec3& p = point.position;
            EXPECT_NEAR(p.x * p.x / 4.0 + p.y * p.y, 1.0, 1e-15);
            // Counterclockwise, so the right is outside: along the gradient of the ellipse's equation.
            const Vec3 gradient = {p.x / 2.0, 2.0 * p.y, 0.0};
            EXPECT_NEAR(dot(point.normal, gradient) / length(gradient), 1.0, 1e-14);
            // Curvature of an ellipse a b / (a^2 sin^2 + b^2 cos^2)^(3/2).
            const double base = 4.0 * p.y * p.y + p.x * p.x / 4.0;
            EXPECT_NEAR(point.curvature, 2.0 / std::pow(base, 1.5), 1e-12);
        }
    }
}

TEST(CurveQuadrature, ConvergesWithItsOrder)
{
    const auto curve = ellipse();
    const double exact = lengthBy(*curve, 4, 4096);
    for (int order = 2; order <= 4; ++order) {
        const double coarse = std::abs(lengthBy(*curve, order, 4) - exact);
        const double fine = std::abs(lengthBy(*curve, order, 8) - exact);
        const double rate = std::log2(coarse / fine);
        EXPECT_NEAR(rate, order == 2 ? 2.0 : 4.0, 0.4) << order;
    }
}

TEST(CurveQuadrature, OfTheHalvesSumsToTheWhole)
{
    const auto curve = ellipse();
    CurvedBoundaryEdge edge;
    edge.parameter = {0.3, 0.5};
    placeGaussPoints(*curve, kUp, 4, edge);
    double whole = 0.0;
    double halves = 0.0;
    for (const auto& point : edge.points) whole += point.weight;
    for (const auto& half : edge.halves) {
        for (const auto& point : half) halves += point.weight;
    }
    EXPECT_NEAR(whole, halves, 1e-6);
    EXPECT_LT(edge.halves[0].back().parameter, 0.4);
    EXPECT_GT(edge.halves[1].front().parameter, 0.4);
}

}  // namespace
}  // namespace mesher
