#pragma once

#include "base/vec.h"
#include "quality/tet_measures.h"

#include <array>
#include <cstddef>

namespace mesher {

/// Sines of obtuse dihedral angles count so much of themselves: at 0.8 an angle of 148 degrees is as bad as one of 25, and one
/// of 141 as bad as one of 30.
inline constexpr double kObtuseWeight = 0.8;

/// What improvement raises: the least sine of the six dihedral angles, those of obtuse ones weighted. 0 for flat and inverted
/// tetrahedra, 0.943 for the regular one, and not sensitive to spires, as the sines are not.
/// Cost         four cross products, four divisions, one root
/// Reference    [klingner2007] has the weight, at 0.7
[[nodiscard]] double dihedralScore(const TetCorners& corners);

/// Gradients of the logarithms of the squared sines by the position of one corner.
struct ScoreGradients
{
    std::array<Vec3, 6> gradient;
    std::size_t count = 0;
};

/// Of the sines of a positive tetrahedron that score at most `ceiling`. Units: 1 / those of the coordinates.
[[nodiscard]] ScoreGradients scoreGradients(const TetCorners& corners, std::size_t moving, double ceiling);

}  // namespace mesher
