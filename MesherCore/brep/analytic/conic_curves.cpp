#include "brep/analytic/conic_curves.h"

#include "base/assert.h"
#include "brep/analytic/periodic.h"
#include "brep/curve_projection.h"

#include <cmath>
#include <numbers>

namespace mesher {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

}  // namespace

ConicCurve::ConicCurve(const Axes& axes, double a, double b, Interval range)
    : axes_(axes), a_(a), b_(b), range_(range)
{
    MESHER_PRECONDITION(a > 0.0 && b > 0.0);
}

Vec3 ConicCurve::position(double t) const { return axes_.toSpace({a_ * std::cos(t), b_ * std::sin(t), 0.0}); }

CurvePoint ConicCurve::evaluate(double t) const
{
    const double c = std::cos(t), s = std::sin(t);
    return {axes_.toSpace({a_ * c, b_ * s, 0.0}), axes_.direction({-a_ * s, b_ * c, 0.0}),
            axes_.direction({-a_ * c, -b_ * s, 0.0})};
}

CurveProjection CircleCurve::project(const Vec3& point, Interval part, std::optional<double>) const
{
    const Vec3 local = axes().toLocal(point);
    double t = part.first;
    if (local.x != 0.0 || local.y != 0.0) {
        t = wrapInto(std::atan2(local.y, local.x), part.first, kTurn);
        // Beyond the part the distance grows up to the point opposite: the nearer end is the closest.
        if (t > part.last) t = t - part.last < part.first + kTurn - t ? part.last : part.first;
    }
    const Vec3 closest = position(t);
    return {t, closest, length(closest - point)};
}

CurveProjection EllipseCurve::project(const Vec3& point, Interval part, std::optional<double> seed) const
{
    if (seed) return projectFromSeed(*this, point, part, *seed);
    // Four extrema at the most in a turn, two of them never nearer than the vertices of the ellipse let them be.
    constexpr int kStations = 24;
    return projectOnCurve(*this, point, projectionStations(*this, part, kStations));
}

}  // namespace mesher
