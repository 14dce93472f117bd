#pragma once

#include "base/vec.h"
#include "brep/planar_curve_complex.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace mesher::test {

/// The regions on the left and right of a curve; 0 is unmeshed.
struct CurveRegions
{
    std::uint32_t left = 1;
    std::uint32_t right = 0;
};

/// Makes planar curve complexes by hand, curve after curve.
class PlanarBuilder
{
public:
    using Sides = CurveRegions;

    PccPointId point(Vec2 p);
    /// A point inside of a region, on no curve.
    PccPointId embed(Vec2 p, std::uint32_t region);

    PccCurveId line(PccPointId a, PccPointId b, Sides sides = {});
    /// A closed chain of lines through the points, the first one last again. Returns the points.
    std::vector<PccPointId> polygon(std::span<const Vec2> corners, Sides sides = {});
    /// Around a centre from one point to another, counter-clockwise if `turn` (radians) is positive.
    PccCurveId arc(PccPointId a, PccPointId b, Vec2 centre, double turn, Sides sides = {});
    /// A closed circle, counter-clockwise unless `isClockwise`; its point lies at `startAngle`.
    PccCurveId circle(Vec2 centre, double radius, Sides sides = {}, bool isClockwise = false,
                      double startAngle = 0.0);
    PccCurveId ellipse(Vec2 centre, double a, double b, double tilt, Sides sides = {},
                       double startAngle = 0.0);
    /// The interpolating cubic spline from a through the inner points to b; a == b closes it, with a corner.
    PccCurveId spline(PccPointId a, std::span<const Vec2> inner, PccPointId b, Sides sides = {});
    PccCurveId bezier(PccPointId a, std::span<const Vec2> inner, PccPointId b, Sides sides = {});
    /// A polyline as one curve of degree 1: its corners lie inside of the curve.
    PccCurveId polyline(PccPointId a, std::span<const Vec2> inner, PccPointId b, Sides sides = {});

    /// Names the regions and hands the complex out.
    [[nodiscard]] PlanarCurveComplex build();

    [[nodiscard]] Vec2 position(PccPointId p) const { return complex_.points[p.value].position; }

private:
    PccCurveId add(std::shared_ptr<const Curve> curve, PccPointId a, PccPointId b, Sides sides);
    [[nodiscard]] std::vector<Vec3> through(PccPointId a, std::span<const Vec2> inner, PccPointId b) const;

    PlanarCurveComplex complex_;
    std::uint32_t regionCount_ = 0;
};

}  // namespace mesher::test
