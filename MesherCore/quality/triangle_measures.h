#pragma once

#include "base/vec.h"

#include <array>

namespace mesher {

using TriangleCorners = std::array<Vec3, 3>;

/// What there is to say about the shape of a triangle in space; angles in degrees, lengths in model units.
struct TriangleShape
{
    double area = 0.0;
    std::array<double, 3> angle{};  ///< at each corner
    double minAngle = 0.0;
    double maxAngle = 0.0;
    double shortestEdge = 0.0;
    double longestEdge = 0.0;
    double radiusRatio = 0.0;  ///< 2 r / R: 1 for the equilateral triangle, 0 for a flat one
};

/// A flat triangle has angles of 0 and 180 degrees and a radius ratio of 0; one with all corners in a point only zeros.
[[nodiscard]] TriangleShape shapeOf(const TriangleCorners& corners);

/// Twice the area times the unit normal, which looks to where the corners are seen counterclockwise from.
[[nodiscard]] constexpr Vec3 doubleAreaVector(const TriangleCorners& corners)
{
    return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

}  // namespace mesher
