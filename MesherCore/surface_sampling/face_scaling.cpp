#include "surface_sampling/face_scaling.h"

#include <algorithm>
#include <cmath>

namespace mesher {

FaceScaling::FaceScaling(const BrepFace& face)
{
    constexpr int kSteps = 5;
    constexpr double kSlightSkew = 0.1;
    double e = 0.0, f = 0.0, g = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const SurfacePoint p = face.surface->evaluate(
                {face.boundsU.at((i + 0.5) / kSteps), face.boundsV.at((j + 0.5) / kSteps)});
            e += squaredLength(p.du);
            f += dot(p.du, p.dv);
            g += squaredLength(p.dv);
        }
    }
    constexpr double kCount = kSteps * kSteps;
    // A direction of no length at all keeps a scale, or points would coincide.
    const double least = 1e-12 * std::max(e, g);
    e = std::max(e, least) / kCount;
    g = std::max(g, least) / kCount;
    f /= kCount;
    if (!(e > 0.0)) return;
    xu_ = std::sqrt(e);
    if (std::abs(f) > kSlightSkew * std::sqrt(e * g)) xv_ = f / xu_;
    yv_ = std::sqrt(std::max(g - xv_ * xv_, 0.01 * g));
}

}  // namespace mesher
