#pragma once

#include "surface_sampling/face_triangulation.h"

#include <optional>

namespace mesher {

/// Inserts the surface's point at these parameters; `hint` is a triangle near it. Nothing is inserted if it falls outside of
/// the face, or on a vertex or piece of the outline.
std::optional<VertexId> insertFacePoint(const BrepFace& face, Vec2 uv, TriangleId hint, FaceTriangulation& t);

/// The parameters in the middle of a side.
[[nodiscard]] Vec2 middleOf(const FacePoint& a, const FacePoint& b);

/// The pole's parameters beside other points: the coordinate that means nothing there is theirs.
[[nodiscard]] Vec2 parametersBeside(const FacePoint& pole, Vec2 others);

}  // namespace mesher
