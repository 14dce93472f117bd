#pragma once

#include "base/vec.h"
#include "brep/brep_ids.h"
#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"

namespace mesher {

/// Tetrahedra that walls need which are thinner than the facets on them, and the place where most of them are.
struct WallEstimate
{
    double elements = 0.0;
    BrepFaceId face;
    Vec3 place;
    double thickness = 0.0;  ///< there, model units
};

/// What thin walls make of a surface mesh: a wall of thickness t is filled with tetrahedra of its own size, so that an area A takes
/// about 3.8 A / t^2 of them (measured on plates of 1 : 30 to 1 : 500).
/// Guarantees   good to a factor of about two on walls whose sides are parallel; facets that meet, at sharp edges, are no walls
/// Cost         a tree of the facets, and a ray from a few thousand of them
[[nodiscard]] WallEstimate estimateWalls(const SurfaceMesh& mesh, const RegionSides& sides);

}  // namespace mesher
