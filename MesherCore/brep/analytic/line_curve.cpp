#include "brep/analytic/line_curve.h"

#include "base/assert.h"

namespace mesher {

LineCurve::LineCurve(const Vec3& origin, const Vec3& direction, Interval range)
    : origin_(origin), direction_(direction), range_(range)
{
    MESHER_PRECONDITION(squaredLength(direction) > 0.0);
}

LineCurve LineCurve::between(const Vec3& a, const Vec3& b)
{
    const double size = length(b - a);
    return LineCurve(a, (1.0 / size) * (b - a), {0.0, size});
}

CurveProjection LineCurve::project(const Vec3& point, Interval part, std::optional<double>) const
{
    const double t = part.clamp(dot(point - origin_, direction_) / squaredLength(direction_));
    const Vec3 closest = position(t);
    return {t, closest, length(closest - point)};
}

}  // namespace mesher
