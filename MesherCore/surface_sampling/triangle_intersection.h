#pragma once

#include "base/vec.h"

#include <array>

namespace mesher {

using TrianglePoints = std::array<Vec3, 3>;

/// Whether a segment has a point in common with a triangle, borders included; exact. A segment in the triangle's plane counts.
/// Requires   a triangle that is not degenerate, points in the exact range (coordinate_range.h)
/// Reference  [devillers2002b] for deciding by orientations alone
[[nodiscard]] bool doesSegmentMeetTriangle(const Vec3& p, const Vec3& q, const TrianglePoints& t);

/// Two triangles without a common corner: whether they have a point in common.
[[nodiscard]] bool doTrianglesMeet(const TrianglePoints& a, const TrianglePoints& b);
/// Two triangles whose corners 0 are the same: whether they have another point in common.
[[nodiscard]] bool doTrianglesMeetBeyondCorner(const TrianglePoints& a, const TrianglePoints& b);
/// Two triangles whose corners 0 and 1 are the same: whether they lie in one plane on one side of their edge.
[[nodiscard]] bool doTrianglesOverlapAtEdge(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace mesher
