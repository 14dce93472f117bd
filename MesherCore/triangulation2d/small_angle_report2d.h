#pragma once

#include "triangulation2d/triangulate_planar.h"

#include <cstddef>
#include <vector>

namespace mesher {

/// What refinement left alone beside one small angle of the input.
struct TrianglesBesideAngle2d
{
    InputAngle angle;
    Vec2 apex;  ///< in the plane, model units
    std::size_t triangles = 0;
    double smallestAngle = 180.0;  ///< of these triangles, degrees
    double largestAngle = 0.0;
};

/// One entry for each small angle of the input beside which a triangle misses the bound, in the order of the complexes and
/// counter-clockwise around each apex. Refinement2d::left has the triangles themselves.
/// Cost         O(n log n) in the triangles left
/// Reference    thesis section 2.5
[[nodiscard]] std::vector<TrianglesBesideAngle2d> trianglesBesideSmallAngles(const PlanarResult& result);

}  // namespace mesher
