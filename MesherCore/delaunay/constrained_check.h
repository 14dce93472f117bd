#pragma once

#include "delaunay/check_report.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"

#include <cstdint>

namespace mesher {

/// Invariant I6, first half: each live segment and facet of the surface mesh is a constrained edge or face with its tag,
/// there are no other constraints, the maps agree, and the vertices stand where their nodes do (scaled). Cost: linear.
CheckReport checkConstraints(const ConstrainedTetrahedralization& tets, const SurfaceMesh& surface);

/// Invariant I6, second half: the tetrahedra beside each facet have the regions of its face's sides, those at the hull are
/// exterior, and the volume of each region is that which its facets enclose (divergence theorem). Cost: linear.
CheckReport checkRegions(const ConstrainedTetrahedralization& tets, const SurfaceMesh& surface,
                         const RegionSides& sides);

enum class DelaunayPart : std::uint8_t
{
    Everywhere,
    Inside  ///< of the solids: of what is kept in the end
};

/// Unconstrained faces with the vertex behind strictly inside of the sphere of the tetrahedron before. None in a constrained
/// Delaunay tetrahedralization; cospherical points may stand in either way. Cost: linear.
std::uint64_t countNonDelaunayFaces(const Triangulation3d& mesh, DelaunayPart part);

}  // namespace mesher
