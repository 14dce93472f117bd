#pragma once

#include "delaunay/check_report.h"
#include "surface_sampling/face_mesh.h"

#include <cstddef>

namespace mesher {

struct FaceMeshCheck
{
    CheckReport report;
    std::size_t vertices = 0;
    std::size_t edges = 0;
    std::size_t triangles = 0;
    std::size_t components = 0;
    std::size_t nonDelaunayEdges =
        0;  ///< those that no segment holds and whose opposite angles exceed 180 degrees
    double leastNormalAgreement = 1.0;  ///< cosine between facets and the surface at their corners
    double largestDistance = 0.0;       ///< between a corner and the surface at its parameters

    [[nodiscard]] long eulerCharacteristic() const
    {
        return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(triangles);
    }
};

/// Checks the mesh of a face: links are symmetric and join sides that run against each other, sides at the border are
/// segments, the two sides of a seam name one segment, no edge is used twice, the triangles around each vertex are one fan or
/// ring, corners lie at their parameters in one image of the face,
/// less than half a period apart.
/// Cost   linear; one surface evaluation per corner
[[nodiscard]] FaceMeshCheck checkFaceMesh(const FaceMesh& mesh, const FaceGeometry& geometry);

}  // namespace mesher
