#pragma once

#include "base/vec.h"
#include "brep/curve.h"

#include <vector>

namespace mesher {

/// A chord that stands for a part of a curve.
struct CurvePiece
{
    Vec3 first;
    Vec3 last;
    double curvature = 0.0;  ///< the larger of those at its ends; per model unit
};

/// A curve as chords for purposes that need no exact place, such as the distance from it by which sizes grow.
/// Guarantees   consecutive chords from one end of the part to the other, cut at all knots, 64 between two of them
[[nodiscard]] std::vector<CurvePiece> piecesOf(const Curve& curve, Interval part);

}  // namespace mesher
