#pragma once

#include "base/vec.h"

namespace mesher {

/// An oriented plane with Cartesian coordinates; the axes are orthonormal and normal = xAxis x yAxis.
struct PlaneFrame
{
    Vec3 origin;
    Vec3 xAxis{1.0, 0.0, 0.0};
    Vec3 yAxis{0.0, 1.0, 0.0};
    Vec3 normal{0.0, 0.0, 1.0};

    [[nodiscard]] constexpr Vec2 toPlane(const Vec3& p) const
    {
        const Vec3 d = p - origin;
        return {dot(d, xAxis), dot(d, yAxis)};
    }
    /// The same for a derivative or direction, which has no origin.
    [[nodiscard]] constexpr Vec2 directionToPlane(const Vec3& d) const
    {
        return {dot(d, xAxis), dot(d, yAxis)};
    }
    [[nodiscard]] constexpr Vec3 toSpace(Vec2 q) const { return origin + q.x * xAxis + q.y * yAxis; }
    /// Signed, in model units.
    [[nodiscard]] constexpr double distanceTo(const Vec3& p) const { return dot(p - origin, normal); }
};

}  // namespace mesher
