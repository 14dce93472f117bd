#pragma once

#include "base/result.h"
#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"

namespace mesher {

/// Refuses what no tetrahedralization can hold: ids out of range, facets with equal or collinear corners, the same facet
/// twice, faces without sides.
Result<void> checkSurfaceInput(const SurfaceMesh& surface, const RegionSides& sides);

}  // namespace mesher
