#pragma once

#include "base/vec.h"

#include <limits>

namespace mesher {

/// What sizing fields answer where they wish for nothing.
inline constexpr double kNoSize = std::numeric_limits<double>::infinity();

/// The edge length wanted at a point of space.
/// Guarantees   positive; kNoSize where the field has no wish; the same answer for the same point
/// Threads      may be asked from several threads at once
/// Units        model units
class SizingField
{
public:
    virtual ~SizingField() = default;
    [[nodiscard]] virtual double sizeAt(const Vec3& point) const = 0;
    /// About the smallest size in a ball: what keeps a mesh from stepping over a small place. Here the field is sampled
    /// at the centre and on the axes; fields that know better override it.
    [[nodiscard]] virtual double smallestNear(const Vec3& centre, double radius) const;
};

}  // namespace mesher
