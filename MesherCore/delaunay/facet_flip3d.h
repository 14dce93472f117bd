#pragma once

#include "delaunay/triangulation3d.h"

#include <array>
#include <vector>

namespace mesher {

/// Replaces the edge between two constrained faces in one plane by the other diagonal of the two, with the two tetrahedra on
/// either side of the plane (4-4); the constraint goes with it. `changed` receives the new tetrahedra. False, with nothing
/// changed, if the edge is constrained or more tetrahedra are around it, or the four corners are not exactly in one plane and
/// strictly convex.
/// Reference    [freitag1997]
bool flipFacetPair(Triangulation3d& mesh, const std::array<VertexId, 2>& edge,
                   const std::array<VertexId, 2>& apices, std::vector<TetId>& changed);

}  // namespace mesher
