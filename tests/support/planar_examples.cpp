#include "support/planar_examples.h"

#include "support/planar_builder.h"

#include <cmath>
#include <numbers>

namespace mesher::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr PlanarBuilder::Sides kHole{0, 1};  // a counter-clockwise curve around a hole of region 1

/// Half the thickness of the four-digit section, closed at the trailing edge.
double nacaHalfThickness(double x, double thickness)
{
    return 5.0 * thickness *
           (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x -
            0.1036 * x * x * x * x);
}

/// An airfoil as two splines from trailing to leading edge and back, mapped into place; counter-clockwise.
void addAirfoil(PlanarBuilder& builder, Vec2 nose, double chord, double degrees, double thickness,
                double camber)
{
    const double angle = degrees * kPi / 180.0;
    const auto place = [&](double x, double y) {
        const double bent = y + camber * 4.0 * x * (1.0 - x);
        return nose + chord * Vec2{x * std::cos(angle) + bent * std::sin(angle),
                                   -x * std::sin(angle) + bent * std::cos(angle)};
    };
    constexpr int kSamples = 14;
    std::vector<Vec2> upper;
    std::vector<Vec2> lower;
    for (int i = 1; i < kSamples; ++i) {
        const double x = 0.5 * (1.0 + std::cos(kPi * i / kSamples));
        upper.push_back(place(x, nacaHalfThickness(x, thickness)));
        lower.insert(lower.begin(), place(x, -nacaHalfThickness(x, thickness)));
    }
    const PccPointId tail = builder.point(place(1.0, 0.0));
    const PccPointId front = builder.point(place(0.0, 0.0));
    builder.spline(tail, upper, front, kHole);
    builder.spline(front, lower, tail, kHole);
}

/// An element of a high-lift airfoil as one spline from the trailing edge around the nose, with a cove on the lower side where
/// the next element retracts: `cove` is the part of the chord it takes.
void addElement(PlanarBuilder& builder, Vec2 nose, double chord, double degrees, double thickness,
                double cove)
{
    const double angle = degrees * kPi / 180.0;
    const auto place = [&](double x, double y) {
        return nose + chord * Vec2{x * std::cos(angle) + y * std::sin(angle),
                                   -x * std::sin(angle) + y * std::cos(angle)};
    };
    const auto lowerAt = [&](double x) {
        // Rises from the lower side to just below the upper one within two hundredths of the chord.
        const double start = 1.0 - cove;
        const double rise = cove > 0.0 ? 1.0 / (1.0 + std::exp(-(x - start - 0.05) / 0.008)) : 0.0;
        const double half = nacaHalfThickness(x, thickness);
        return -half + 1.7 * half * rise;
    };
    constexpr int kSamples = 100;
    std::vector<Vec2> inner;
    for (int i = 1; i < 2 * kSamples; ++i) {
        const double x = 0.5 * (1.0 + std::cos(kPi * i / kSamples));
        inner.push_back(place(x, i <= kSamples ? nacaHalfThickness(x, thickness) : lowerAt(x)));
    }
    const PccPointId tail = builder.point(place(1.0, 0.0));
    builder.spline(tail, inner, tail, kHole);
}

void addRectangle(PlanarBuilder& builder, Vec2 low, Vec2 high, PlanarBuilder::Sides sides = {})
{
    const Vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    builder.polygon(corners, sides);
}

/// A wavy closed spline around a centre, counter-clockwise.
void addBlob(PlanarBuilder& builder, Vec2 centre, double radius, int lobes, double depth,
             PlanarBuilder::Sides sides)
{
    const int samples = 6 * lobes;
    const auto at = [&](int i) {
        const double angle = 2.0 * kPi * i / samples;
        const double r = radius * (1.0 + depth * std::cos(lobes * angle));
        return centre + r * Vec2{std::cos(angle), std::sin(angle)};
    };
    const PccPointId start = builder.point(at(0));
    std::vector<Vec2> inner;
    for (int i = 1; i < samples; ++i) inner.push_back(at(i));
    builder.spline(start, inner, start, sides);
}

}  // namespace

PlanarCurveComplex annulus()
{
    PlanarBuilder builder;
    builder.circle({0.0, 0.0}, 2.0);
    builder.circle({0.0, 0.0}, 1.0, kHole);
    return builder.build();
}

PlanarCurveComplex nacaInFarField()
{
    PlanarBuilder builder;
    builder.circle({0.5, 0.0}, 20.0);
    addAirfoil(builder, {0.0, 0.0}, 1.0, 0.0, 0.12, 0.0);
    return builder.build();
}

PlanarCurveComplex threeElementAirfoil()
{
    PlanarBuilder builder;
    builder.circle({0.5, 0.0}, 3.0);
    addElement(builder, {-0.155, -0.09}, 0.17, -32.0, 0.22, 0.75);
    addElement(builder, {0.03, 0.0}, 0.80, 0.0, 0.16, 0.35);
    addElement(builder, {0.865, -0.075}, 0.27, 35.0, 0.18, 0.0);
    return builder.build();
}

PlanarCurveComplex manyDisjointRegions()
{
    PlanarBuilder builder;
    std::uint32_t region = 0;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 5; ++column) {
            const Vec2 centre{1.03 * column, 1.03 * row};
            ++region;
            switch ((row + column) % 3) {
                case 0: addBlob(builder, centre, 0.42, 3 + column, 0.15, {region, 0}); break;
                case 1:
                    addRectangle(builder, centre - Vec2{0.5, 0.5}, centre + Vec2{0.5, 0.5}, {region, 0});
                    break;
                default: builder.ellipse(centre, 0.5, 0.2 + 0.05 * row, 0.3 * column, {region, 0}); break;
            }
        }
    }
    return builder.build();
}

PlanarCurveComplex splineCavity()
{
    PlanarBuilder builder;
    const PccPointId corners[] = {builder.point({0.0, 0.0}), builder.point({4.0, 0.2}),
                                  builder.point({5.0, 3.0}), builder.point({1.0, 3.4})};
    // Sides that leave some corners at small angles.
    const Vec2 first[] = {{1.0, 0.9}, {2.2, 0.5}, {3.1, 0.9}};
    const Vec2 second[] = {{3.6, 1.0}, {4.4, 1.9}};
    const Vec2 third[] = {{3.9, 2.2}, {2.8, 2.9}, {1.9, 2.6}};
    const Vec2 fourth[] = {{1.0, 2.3}, {0.2, 1.4}, {0.25, 0.6}};
    builder.spline(corners[0], first, corners[1]);
    builder.spline(corners[1], second, corners[2]);
    builder.spline(corners[2], third, corners[3]);
    builder.spline(corners[3], fourth, corners[0]);
    addBlob(builder, {2.2, 1.7}, 0.45, 4, 0.2, kHole);
    return builder.build();
}

PlanarCurveComplex smallAngleFan()
{
    PlanarBuilder builder;
    addRectangle(builder, {-2.0, -2.0}, {2.0, 2.0});
    const PccPointId apex = builder.point({0.0, 0.0});
    const PlanarBuilder::Sides inside{1, 1};
    const double gaps[] = {0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 30.0, 45.0};
    double angle = 10.0;
    int index = 0;
    for (const double gap : gaps) {
        angle += gap;
        const double a = angle * kPi / 180.0;
        const double reach = 0.9 + 0.1 * (index % 3);
        const Vec2 ahead{std::cos(a), std::sin(a)};
        const PccPointId end = builder.point(reach * ahead);
        if (index++ % 2 == 0) {
            builder.line(apex, end, inside);
        } else {
            // Leaves at the ray's angle and bends a little away from the next one.
            const Vec2 aside{ahead.y, -ahead.x};
            const Vec2 control[] = {0.4 * ahead, 0.7 * reach * ahead + 0.002 * aside};
            builder.bezier(apex, control, end, inside);
        }
    }
    return builder.build();
}

PlanarCurveComplex overlappingHulls()
{
    PlanarBuilder builder;
    addRectangle(builder, {-2.0, -1.0}, {2.0, 2.5});
    // Two concentric arcs, the outer one shorter, so that no end lies in the diametral circle of the other's edge: enrichment
    // leaves both alone. The middle of the inner arc, which is split first, lies beyond the outer one's edge.
    const auto addArc = [&](double radius, double halfTurn) {
        const double start = 0.5 * kPi - halfTurn;
        const auto at = [&](double angle) { return radius * Vec2{std::cos(angle), std::sin(angle)}; };
        const PccPointId a = builder.point(at(start));
        const PccPointId b = builder.point(at(start + 2.0 * halfTurn));
        builder.arc(a, b, {0.0, 0.0}, 2.0 * halfTurn, {1, 1});
    };
    addArc(1.0, 45.0 * kPi / 180.0);
    addArc(1.03, 43.35 * kPi / 180.0);
    return builder.build();
}

PlanarCurveComplex bulgeOutsideOfCircles()
{
    PlanarBuilder builder;
    const PccPointId a = builder.point({-1.0, 0.0});
    const PccPointId b = builder.point({1.0, 0.0});
    const PccPointId c = builder.point({1.0, 4.0});
    const PccPointId d = builder.point({-1.0, 4.0});
    // A quarter arc, split first, below a tall rectangle, whose circle reaches less far down.
    builder.arc(a, b, {0.0, 1.0}, 0.5 * kPi);
    builder.line(b, c);
    builder.line(c, d);
    builder.line(d, a);
    return builder.build();
}

PlanarCurveComplex thinHoleBetweenArcs()
{
    PlanarBuilder builder;
    addRectangle(builder, {-2.0, -1.0}, {2.0, 3.0}, {1, 0});
    const Vec2 centre{0.0, 0.0};
    const auto at = [&](double radius, double angle) {
        return radius * Vec2{std::cos(angle), std::sin(angle)};
    };
    const double start = 0.25 * kPi;
    const double turn = 0.5 * kPi;
    const PccPointId a = builder.point(at(1.0, start));
    const PccPointId b = builder.point(at(1.0, start + turn));
    const PccPointId c = builder.point(at(1.03, start + turn));
    const PccPointId d = builder.point(at(1.03, start));
    // Counter-clockwise around the hole, the inner arc first: it is then split first, and its middle lies beyond the outer
    // arc's edge.
    builder.arc(b, a, centre, -turn, kHole);
    builder.line(a, d, kHole);
    builder.arc(d, c, centre, turn, kHole);
    builder.line(c, b, kHole);
    return builder.build();
}

PlanarCurveComplex unitSquare()
{
    PlanarBuilder builder;
    addRectangle(builder, {0.0, 0.0}, {1.0, 1.0});
    return builder.build();
}

std::vector<PlanarExample> allPlanarExamples()
{
    std::vector<PlanarExample> examples;
    examples.push_back({"annulus", annulus()});
    examples.push_back({"naca0012", nacaInFarField()});
    examples.push_back({"three_element_airfoil", threeElementAirfoil()});
    examples.push_back({"disjoint_regions", manyDisjointRegions()});
    examples.push_back({"spline_cavity", splineCavity()});
    examples.push_back({"small_angle_fan", smallAngleFan()});
    examples.push_back({"overlapping_hulls", overlappingHulls()});
    examples.push_back({"bulge_outside_of_circles", bulgeOutsideOfCircles()});
    examples.push_back({"thin_hole_between_arcs", thinHoleBetweenArcs()});
    examples.push_back({"unit_square", unitSquare()});
    return examples;
}

}  // namespace mesher::test
