#pragma once

#include "base/run_context.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/classified_mesh.h"
#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"

namespace mesher {

/// Takes the solids out of a tetrahedralization: nodes on the surface in the order of the surface mesh, then those inside in
/// the order of the vertices; points by model vertex, lines by edge and parameter, triangles by face, tetrahedra by solid.
/// Triangles with a solid on one side look away from it; those between two solids look out of the one that comes first in the
/// model. Lines along a seam are left out: a seam is no feature of the shape, and no edge of a triangle need run along it.
/// Requires     regions 1 … n of the solids 0 … n - 1
/// Terminates   early when the run is to end; the mesh is worth nothing then
/// Cost         linear, and a sort of the lines
[[nodiscard]] ClassifiedMesh classifySolids(const ConstrainedTetrahedralization& tetrahedralization,
                                            const SurfaceMesh& surface, const RegionSides& sides,
                                            RunContext& context);

/// The surface alone: triangles turned as above.
[[nodiscard]] ClassifiedMesh classifySurface(const SurfaceMesh& surface, const RegionSides& sides,
                                             RunContext& context);

}  // namespace mesher
