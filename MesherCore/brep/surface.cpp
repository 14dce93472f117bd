#include "brep/surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mesher {

std::optional<SurfaceCurvature> curvatureOf(const SurfacePoint& point)
{
    const Vec3 normal = point.normal();
    const double size = length(normal);
    const double e = dot(point.du, point.du);
    const double f = dot(point.du, point.dv);
    const double g = dot(point.dv, point.dv);
    const double area2 = e * g - f * f;
    if (!(size > 0.0) || !(area2 > 0.0)) return {};
    const Vec3 n = (1.0 / size) * normal;
    const double l = dot(point.duu, n);
    const double m = dot(point.duv, n);
    const double k = dot(point.dvv, n);
    const double mean = 0.5 * (e * k - 2.0 * f * m + g * l) / area2;
    const double gauss = (l * k - m * m) / area2;
    const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
    SurfaceCurvature curvature{mean + root, mean - root};
    if (std::abs(curvature.smallest) > std::abs(curvature.largest))
        std::swap(curvature.largest, curvature.smallest);
    return curvature;
}

}  // namespace mesher
