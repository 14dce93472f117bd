#pragma once

#include "base/vec.h"

#include <array>
#include <concepts>
#include <cstddef>

namespace mesher::detail {

/// The coordinates of some points of the plane, one after the other.
template <std::same_as<Vec2>... Points>
std::array<double, 2 * sizeof...(Points)> flatCoordinates(const Points&... points)
{
    std::array<double, 2 * sizeof...(Points)> flat;
    std::size_t i = 0;
    ((flat[i++] = points.x, flat[i++] = points.y), ...);
    return flat;
}

/// The same in space.
template <std::same_as<Vec3>... Points>
std::array<double, 3 * sizeof...(Points)> flatCoordinates(const Points&... points)
{
    std::array<double, 3 * sizeof...(Points)> flat;
    std::size_t i = 0;
    ((flat[i++] = points.x, flat[i++] = points.y, flat[i++] = points.z), ...);
    return flat;
}

}  // namespace mesher::detail
