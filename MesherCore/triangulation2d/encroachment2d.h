#pragma once

#include "base/vec.h"

namespace mesher {

/// Strictly inside the circle whose diameter is the edge from a to b: the edge is seen under an obtuse angle.
[[nodiscard]] inline bool isInDiametralCircle(Vec2 a, Vec2 b, Vec2 p) { return dot(a - p, b - p) < 0.0; }

/// Inside the diametral lens: the edge is seen under more than 120 degrees.
/// Reference    thesis Fig. 2.3; [shewchuk2002]
[[nodiscard]] inline bool isInDiametralLens(Vec2 a, Vec2 b, Vec2 p)
{
    const Vec2 u = a - p;
    const Vec2 v = b - p;
    const double product = dot(u, v);
    return product < 0.0 && 4.0 * product * product > squaredLength(u) * squaredLength(v);
}

}  // namespace mesher
