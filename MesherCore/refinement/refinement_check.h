#pragma once

#include "delaunay/check_report.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_mesh.h"

namespace mesher {

/// Invariant I7: topology, orientation and regions (checkTopology3d); each live segment and facet is a constrained edge or
/// face and there are no others; the maps between nodes and vertices are inverse and agree in position; the maps of
/// segments and facets name exactly the live ones.
/// Cost: linear.
[[nodiscard]] CheckReport checkRefinement(const ConstrainedTetrahedralization& tetrahedralization,
                                          const SurfaceMesh& surface);

}  // namespace mesher
