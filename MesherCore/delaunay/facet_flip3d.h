#pragma once

#include "delaunay/triangulation3d.h"

#include <array>
#include <optional>
#include <vector>

namespace mesher {

/// Replaces the edge between two constrained faces in one plane by the other diagonal of the two, with the two tetrahedra on
/// either side of the plane (4-4); the constraint goes with it. `changed` receives the new tetrahedra. False, with nothing
/// changed, if the edge is constrained or more tetrahedra are around it, or the four corners are not exactly in one plane and
/// strictly convex.
/// Reference    [freitag1997]
bool flipFacetPair(Triangulation3d& mesh, const std::array<VertexId, 2>& edge,
                   const std::array<VertexId, 2>& apices, std::vector<TetId>& changed);

/// Replaces the tetrahedra of a region at an edge between two constrained faces by the star of a new vertex. That leaves two of
/// them at the edge, or the one of the four corners of the faces where these are not exactly in one plane and bend away from
/// the region. Nothing, with nothing changed, if there are no more than two, a ghost is among them or no point sees all of
/// their surface.
std::optional<VertexId> clearBesideEdge(Triangulation3d& mesh, const std::array<VertexId, 2>& edge,
                                        RegionId region);

}  // namespace mesher
