#include "brep/analytic/round_surfaces.h"

#include "brep/analytic/periodic.h"

#include <algorithm>
#include <cmath>

namespace mesher {

Vec3 RoundSurface::position(Vec2 uv) const
{
    const Profile p = profile(uv.y);
    return axes_.toSpace({p.radius[0] * std::cos(uv.x), p.radius[0] * std::sin(uv.x), p.height[0]});
}

SurfacePoint RoundSurface::evaluate(Vec2 uv) const
{
    const Profile p = profile(uv.y);
    const double c = std::cos(uv.x), s = std::sin(uv.x);
    const auto& r = p.radius;
    const auto& h = p.height;
    return {axes_.toSpace({r[0] * c, r[0] * s, h[0]}),   axes_.direction({-r[0] * s, r[0] * c, 0.0}),
            axes_.direction({r[1] * c, r[1] * s, h[1]}), axes_.direction({-r[0] * c, -r[0] * s, 0.0}),
            axes_.direction({-r[1] * s, r[1] * c, 0.0}), axes_.direction({r[2] * c, r[2] * s, h[2]})};
}

SurfaceProjection RoundSurface::project(const Vec3& point, std::optional<Vec2> seed) const
{
    const Vec3 local = axes_.toLocal(point);
    const double radius = std::hypot(local.x, local.y);
    const bool isOnAxis = radius == 0.0;
    const double angle = isOnAxis && seed ? seed->x : std::atan2(local.y, local.x);
    const auto candidate = [&](double side) {
        const double v = closestOnProfile(side * radius, local.z);
        const double u = side > 0.0 || (isOnAxis && seed) ? angle : angle + 0.5 * kTurn;
        const double period = periodV();
        SurfaceProjection result;
        result.parameters.x = seed ? wrapNear(u, seed->x, kTurn) : wrapInto(u, 0.0, kTurn);
        result.parameters.y =
            period == 0.0 ? v : (seed ? wrapNear(v, seed->y, period) : wrapInto(v, 0.0, period));
        result.position = position(result.parameters);
        result.distance = length(result.position - point);
        return result;
    };
    const SurfaceProjection near = candidate(1.0);
    if (!crossesAxis()) return near;
    const SurfaceProjection far = candidate(-1.0);
    if (seed) {
        const bool isSeedNegative = profile(seed->y).radius[0] < 0.0;
        const bool isNearSame = (profile(near.parameters.y).radius[0] < 0.0) == isSeedNegative;
        const bool isFarSame = (profile(far.parameters.y).radius[0] < 0.0) == isSeedNegative;
        if (isNearSame != isFarSame) return isNearSame ? near : far;
    }
    return far.distance < near.distance ? far : near;
}

RoundSurface::Profile CylinderSurface::profile(double v) const
{
    return {{radius_, 0.0, 0.0}, {v, 1.0, 0.0}};
}

ConeSurface::ConeSurface(const Axes& axes, double radius, double semiAngle)
    : RoundSurface(axes), radius_(radius), sine_(std::sin(semiAngle)), cosine_(std::cos(semiAngle))
{
}

RoundSurface::Profile ConeSurface::profile(double v) const
{
    return {{radius_ + v * sine_, sine_, 0.0}, {v * cosine_, cosine_, 0.0}};
}

double ConeSurface::closestOnProfile(double radius, double height) const
{
    return (radius - radius_) * sine_ + height * cosine_;
}

RoundSurface::Profile SphereSurface::profile(double v) const
{
    const double c = radius_ * std::cos(v), s = radius_ * std::sin(v);
    return {{c, -s, -c}, {s, c, -s}};
}

double SphereSurface::closestOnProfile(double radius, double height) const
{
    return std::atan2(height, radius);
}

RoundSurface::Profile TorusSurface::profile(double v) const
{
    const double c = tubeRadius_ * std::cos(v), s = tubeRadius_ * std::sin(v);
    return {{ringRadius_ + c, -s, -c}, {s, c, -s}};
}

std::vector<double> TorusSurface::pinchesV() const
{
    constexpr double kRounding = 1e-9;
    if (tubeRadius_ < ringRadius_ * (1.0 - kRounding)) return {};
    const double first = std::acos(std::max(-1.0, -ringRadius_ / tubeRadius_));
    return {first, kTurn - first};
}

double TorusSurface::closestOnProfile(double radius, double height) const
{
    return std::atan2(height, radius - ringRadius_);
}

}  // namespace mesher
