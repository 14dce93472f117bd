#include "brep/analytic/plane_surface.h"

namespace mesher {

SurfacePoint PlaneSurface::evaluate(Vec2 uv) const
{
    return {frame_.toSpace(uv), frame_.xAxis, frame_.yAxis, {}, {}, {}};
}

SurfaceProjection PlaneSurface::project(const Vec3& point, std::optional<Vec2>) const
{
    const Vec2 uv = frame_.toPlane(point);
    const Vec3 closest = frame_.toSpace(uv);
    return {uv, closest, length(closest - point)};
}

}  // namespace mesher
