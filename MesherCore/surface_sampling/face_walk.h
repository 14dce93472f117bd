#pragma once

#include "base/vec.h"
#include "surface_sampling/face_mesh.h"

namespace mesher {

/// Where a walk over the facets of a face has ended.
struct FaceWalk
{
    enum class Outcome
    {
        Inside,   ///< the triangle holds the point
        Blocked,  ///< a segment lies between; `side` is the near side of it
        Lost      ///< the surface turns away from the point
    };

    Outcome outcome = Outcome::Lost;
    TriangleId triangle;
    EdgeLink side;
    Vec2 shift;  ///< to be taken from parameters in the first triangle's image to have them in the last one's
};

/// Walks from a triangle straight towards a point near the surface: along the plane that holds the triangle's centroid, its
/// normal and the point. Triangles are told apart at the planes of sideOfEdge.
/// Terminates   after 200 triangles
[[nodiscard]] FaceWalk walkToPoint(const FaceMesh& mesh, const FaceGeometry& geometry, TriangleId start,
                                   const Vec3& point);

}  // namespace mesher
