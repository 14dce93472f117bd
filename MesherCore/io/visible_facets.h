#pragma once

#include "io/draw_png.h"
#include "mesh/classified_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mesher {

/// A triangle that a picture of a mesh shows: one of the mesh, or a side of a tetrahedron.
struct VisibleFacet
{
    std::array<NodeId, 3> node;
    EntityRef entity;  ///< a face; a solid where the mesh is cut open
};

/// A plane across an axis (0, 1, 2 for x, y, z) at a coordinate.
struct CutPlane
{
    std::size_t axis = 1;
    double at = 0.0;
};

/// The plane asked for; without one across x or y, whichever way the mesh is shorter, and through its middle.
[[nodiscard]] CutPlane cutPlaneOf(const ClassifiedMesh& mesh, const DrawingOptions& options);

/// The triangles of a mesh; of one that has tetrahedra alone their sides that are of one only.
[[nodiscard]] std::vector<VisibleFacet> surfaceOf(const ClassifiedMesh& mesh);

/// The surface of the tetrahedra (without any: the triangles) whose middles are behind the plane, seen from `towardsEye`.
/// Guarantees   every facet of the model's faces in it keeps its face
/// Cost         one sort of the sides of tetrahedra
[[nodiscard]] std::vector<VisibleFacet> cutSurfaceOf(const ClassifiedMesh& mesh, const CutPlane& plane,
                                                     const Vec3& towardsEye);

}  // namespace mesher
