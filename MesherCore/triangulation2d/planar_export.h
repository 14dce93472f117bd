#pragma once

#include "mesh/classified_mesh.h"
#include "triangulation2d/planar_triangulation.h"

#include <span>

namespace mesher {

/// Hands the triangles of the regions out as a finished mesh; what is unmeshed stays behind.
/// Guarantees   nodes at points and on curves have the exact position in space, those inside lie in the plane; a node's
///              parameter on its curve in parameters.x, its place in the plane's axes otherwise; nodes, lines and triangles
///              come in an order that depends on the triangulation's numbering only
/// Requires     `faces[r - 1]` for each region r
[[nodiscard]] ClassifiedMesh exportPlanarMesh(const PlanarDomain& domain,
                                              const PlanarTriangulation& triangulation,
                                              std::span<const EntityRef> faces);

}  // namespace mesher
