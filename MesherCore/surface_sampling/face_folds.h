#pragma once

#include "surface_sampling/face_triangulation.h"

#include <array>

namespace mesher {

// Patches that a rounding ends in leave the face beside their edge within the tolerance, and turn by a right angle there: no
// facet follows what is narrower than the face is exact.

/// Has the lifted triangle an area, and does it look to the side of the surface at each of its corners?
[[nodiscard]] bool isUpright(const std::array<const FacePoint*, 3>& corners);

/// Is the lifted triangle's height above its longest side less than the face's tolerance? False if it is flat but for rounding: then
/// it is so by its corners, and further points mend it.
[[nodiscard]] bool isWithinTolerance(const BrepFace& face, const std::array<const FacePoint*, 3>& corners);

/// Are these parameters, in space, within the face's tolerance of the line of a piece of the outline? Of the pieces at the triangle
/// around them; `hint` is a triangle near it.
[[nodiscard]] bool isOnPiece(const BrepFace& face, const FaceTriangulation& t, Vec2 uv, TriangleId hint);

}  // namespace mesher
