#pragma once

#include "base/box.h"

#include <algorithm>

namespace mesher {

/// The place on a segment that is closest to a point, as the share of the way from a to b; 0 if the segment is a point.
inline double closestShare(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 edge = b - a;
    const double square = squaredLength(edge);
    return square > 0.0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
}

/// From a point to the nearest one of a box; 0 inside.
inline double squaredDistance(const Vec3& p, const Box3& box)
{
    return squaredLength(Vec3{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                              std::max({box.low.y - p.y, 0.0, p.y - box.high.y}),
                              std::max({box.low.z - p.z, 0.0, p.z - box.high.z})});
}

}  // namespace mesher
