#pragma once

#include "surface_sampling/face_triangulation.h"

#include <optional>

namespace mesher {

/// Inserts the surface's point at these parameters; `hint` is a triangle near it. Nothing is inserted if it falls outside of
/// the face, or nearer to a vertex or a piece of the outline than a share `clearance` of the longest side there, or than
/// `leastDistance` in the plane: between two points that are one but for rounding there is no facet that knows its normal.
std::optional<VertexId> insertFacePoint(const BrepFace& face, Vec2 uv, TriangleId hint, FaceTriangulation& t,
                                        double clearance = 1e-6, double leastDistance = 0.0);

/// Inserts a further image of a pole on the pole's line, level with `other`, so that they can be joined by a straight side.
/// Nothing is inserted if there is one, or if rounding puts it off the line.
std::optional<VertexId> insertPoleImage(VertexId pole, const FacePoint& other, TriangleId hint,
                                        FaceTriangulation& t);

/// The parameters in the middle of a side in the plane.
[[nodiscard]] Vec2 middleOf(const FacePoint& a, const FacePoint& b);

/// The parameters beneath the middle of a lifted side, which differ from those in the plane beside a pole.
[[nodiscard]] Vec2 liftedMiddleOf(const FacePoint& a, const FacePoint& b);

/// The pole's parameters beside other points: the coordinate that means nothing there is theirs.
[[nodiscard]] Vec2 parametersBeside(const FacePoint& pole, Vec2 others);

}  // namespace mesher
