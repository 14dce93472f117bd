#pragma once

#include "base/vec.h"

#include <array>
#include <span>

namespace mesher {

/// The point whose least distance from the planes of some triangles is largest, counted positive in front of them
/// (counter-clockwise): where that distance is positive, the middle of the largest ball that all of the triangles see from
/// behind it. Rounded: who needs to know has to test it.
/// Requires     at least one triangle; those without area are left out
/// Terminates   after a fixed number of steps
/// Cost         proportional to the triangles, times some ten steps
/// Reference    the simplex method on the dual of this linear programme, whose bases are four planes
[[nodiscard]] Vec3 deepestPoint(std::span<const std::array<Vec3, 3>> triangles);

}  // namespace mesher
