#include "support/planar_builder.h"

#include "brep/analytic/bspline_curve.h"
#include "brep/analytic/conic_curves.h"
#include "brep/analytic/line_curve.h"
#include "brep/analytic/spline_interpolation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace mesher::test {
namespace {

Vec3 inSpace(Vec2 p) { return {p.x, p.y, 0.0}; }

template <class T>
T valueOf(Result<T> result)
{
    if (!result) std::abort();
    return std::move(*result);
}

Axes axesAt(Vec2 centre, double angle, bool isMirrored)
{
    Axes axes;
    axes.origin = inSpace(centre);
    axes.x = {std::cos(angle), std::sin(angle), 0.0};
    axes.y = {-std::sin(angle), std::cos(angle), 0.0};
    if (isMirrored) axes.y = -1.0 * axes.y;
    return axes;
}

}  // namespace

PccPointId PlanarBuilder::point(Vec2 p)
{
    complex_.points.push_back({p, inSpace(p), {}});
    return PccPointId(static_cast<std::uint32_t>(complex_.points.size() - 1));
}

PccPointId PlanarBuilder::embed(Vec2 p, std::uint32_t region)
{
    const PccPointId id = point(p);
    complex_.embeddedPoints.push_back({id, RegionId(region)});
    return id;
}

PccCurveId PlanarBuilder::add(std::shared_ptr<const Curve> curve, PccPointId a, PccPointId b, Sides sides)
{
    regionCount_ = std::max({regionCount_, sides.left, sides.right});
    const Interval range = curve->range();
    complex_.curves.push_back(
        {std::move(curve), range, a, b, RegionId(sides.left), RegionId(sides.right), {}});
    return PccCurveId(static_cast<std::uint32_t>(complex_.curves.size() - 1));
}

PccCurveId PlanarBuilder::line(PccPointId a, PccPointId b, Sides sides)
{
    return add(std::make_shared<LineCurve>(LineCurve::between(inSpace(position(a)), inSpace(position(b)))), a,
               b, sides);
}

std::vector<PccPointId> PlanarBuilder::polygon(std::span<const Vec2> corners, Sides sides)
{
    std::vector<PccPointId> points;
    for (const Vec2 corner : corners) points.push_back(point(corner));
    for (std::size_t i = 0; i < points.size(); ++i) line(points[i], points[(i + 1) % points.size()], sides);
    return points;
}

PccCurveId PlanarBuilder::arc(PccPointId a, PccPointId b, Vec2 centre, double turn, Sides sides)
{
    const Vec2 offset = position(a) - centre;
    const Axes axes = axesAt(centre, std::atan2(offset.y, offset.x), turn < 0.0);
    return add(std::make_shared<CircleCurve>(axes, length(offset), Interval{0.0, std::abs(turn)}), a, b,
               sides);
}

PccCurveId PlanarBuilder::circle(Vec2 centre, double radius, Sides sides, bool isClockwise, double startAngle)
{
    const PccPointId p = point(centre + radius * Vec2{std::cos(startAngle), std::sin(startAngle)});
    const Axes axes = axesAt(centre, startAngle, isClockwise);
    return add(std::make_shared<CircleCurve>(axes, radius, Interval{0.0, 2.0 * std::numbers::pi}), p, p,
               sides);
}

PccCurveId PlanarBuilder::ellipse(Vec2 centre, double a, double b, double tilt, Sides sides,
                                  double startAngle)
{
    const Axes axes = axesAt(centre, tilt, false);
    const auto curve =
        std::make_shared<EllipseCurve>(axes, a, b, Interval{startAngle, startAngle + 2.0 * std::numbers::pi});
    const Vec3 start = curve->position(startAngle);
    const PccPointId p = point({start.x, start.y});
    return add(curve, p, p, sides);
}

std::vector<Vec3> PlanarBuilder::through(PccPointId a, std::span<const Vec2> inner, PccPointId b) const
{
    std::vector<Vec3> points{inSpace(position(a))};
    for (const Vec2 p : inner) points.push_back(inSpace(p));
    points.push_back(inSpace(position(b)));
    return points;
}

PccCurveId PlanarBuilder::spline(PccPointId a, std::span<const Vec2> inner, PccPointId b, Sides sides)
{
    return add(valueOf(interpolateCubic(through(a, inner, b))), a, b, sides);
}

PccCurveId PlanarBuilder::bezier(PccPointId a, std::span<const Vec2> inner, PccPointId b, Sides sides)
{
    return add(valueOf(BSplineCurve::makeBezier(through(a, inner, b))), a, b, sides);
}

PccCurveId PlanarBuilder::polyline(PccPointId a, std::span<const Vec2> inner, PccPointId b, Sides sides)
{
    BSplineData data;
    data.degree = 1;
    data.poles = through(a, inner, b);
    data.knots.push_back(0.0);
    for (std::size_t i = 0; i < data.poles.size(); ++i) data.knots.push_back(static_cast<double>(i));
    data.knots.push_back(static_cast<double>(data.poles.size() - 1));
    return add(valueOf(BSplineCurve::make(std::move(data))), a, b, sides);
}

PlanarCurveComplex PlanarBuilder::build()
{
    complex_.regionNames.clear();
    for (std::uint32_t i = 1; i <= regionCount_; ++i)
        complex_.regionNames.push_back("Face" + std::to_string(i));
    return std::move(complex_);
}

}  // namespace mesher::test
