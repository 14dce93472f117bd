#pragma once

#include "base/vec.h"

#include <array>

namespace mesher {

using TetPoints = std::array<Vec3, 4>;

/// The volume that two tetrahedra, both positively oriented, have in common: one is cut by the planes of the other's sides.
[[nodiscard]] double commonVolume(const TetPoints& a, const TetPoints& b);

}  // namespace mesher
