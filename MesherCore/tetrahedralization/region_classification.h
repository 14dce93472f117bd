#pragma once

#include "base/result.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/region_sides.h"

namespace mesher {

/// Gives each tetrahedron the region that the faces around it tell, from facet to facet without crossing one; those that reach
/// the hull are exterior.
/// Errors   a face whose side contradicts another's, or a solid that is open to the outside (InvalidArgument; names the face)
/// Cost     linear
Result<void> classifyRegions(ConstrainedTetrahedralization& tets, const SurfaceMesh& surface,
                             const RegionSides& sides);

}  // namespace mesher
