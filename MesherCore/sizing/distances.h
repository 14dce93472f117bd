#pragma once

#include "base/box.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace mesher {

/// The place on a segment that is closest to a point, as the share of the way from a to b; 0 if the segment is a point.
inline double closestShare(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 edge = b - a;
    const double square = squaredLength(edge);
    return square > 0.0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
}

/// Barycentric coordinates of the point of a triangle that is closest to p. The triangle may have no area.
inline std::array<double, 3> closestWeights(const Vec3& p, const std::array<Vec3, 3>& corner)
{
    const auto& [a, b, c] = corner;
    const Vec3 normal = cross(b - a, c - a);
    const double square = squaredLength(normal);
    if (square > 0.0) {
        const double wb = dot(cross(p - a, c - a), normal) / square;
        const double wc = dot(cross(b - a, p - a), normal) / square;
        if (wb >= 0.0 && wc >= 0.0 && wb + wc <= 1.0) return {1.0 - wb - wc, wb, wc};
    }
    std::array<double, 3> best = {1.0, 0.0, 0.0};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double share = closestShare(p, corner[i], corner[j]);
        const double distance = squaredLength(p - ((1.0 - share) * corner[i] + share * corner[j]));
        if (distance >= least) continue;
        least = distance;
        best = {0.0, 0.0, 0.0};
        best[i] = 1.0 - share;
        best[j] = share;
    }
    return best;
}

/// From a point to the nearest one of a box; 0 inside.
inline double squaredDistance(const Vec3& p, const Box3& box)
{
    return squaredLength(Vec3{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                              std::max({box.low.y - p.y, 0.0, p.y - box.high.y}),
                              std::max({box.low.z - p.z, 0.0, p.z - box.high.z})});
}

}  // namespace mesher
