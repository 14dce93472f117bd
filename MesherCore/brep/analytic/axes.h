#pragma once

#include "base/vec.h"

namespace mesher {

/// Orthonormal axes of a conic or of a surface of revolution. They may be left-handed, as those of a mirrored part.
struct Axes
{
    Vec3 origin;
    Vec3 x{1.0, 0.0, 0.0};
    Vec3 y{0.0, 1.0, 0.0};
    Vec3 z{0.0, 0.0, 1.0};

    [[nodiscard]] constexpr Vec3 toLocal(const Vec3& p) const
    {
        const Vec3 d = p - origin;
        return {dot(d, x), dot(d, y), dot(d, z)};
    }
    [[nodiscard]] constexpr Vec3 direction(const Vec3& local) const
    {
        return local.x * x + local.y * y + local.z * z;
    }
    [[nodiscard]] constexpr Vec3 toSpace(const Vec3& local) const { return origin + direction(local); }
};

}  // namespace mesher
