#pragma once

#include "delaunay/check_report.h"
#include "delaunay/triangulation3d.h"

#include <cstdint>

namespace mesher {

/// Invariant I1: four different vertices each, ghosts last; symmetric links of equal faces seen in opposite senses; finite tetrahedra positively
/// oriented; Euler characteristic 0 of the 3-sphere; incident tetrahedra of vertices; constraint flags equal in all
/// tetrahedra that share the face or edge; regions change at constrained faces and at the hull only; no scratch mark left.
/// Cost: linear, with a hash table of edges.
CheckReport checkTopology3d(const Triangulation3d& mesh);

enum class DelaunayScope : std::uint8_t
{
    Local,  ///< each unconstrained face against the vertices opposite it: linear, implies the global property if
            ///< there are no constraints
    Global  ///< each tetrahedron against each vertex: quadratic; for triangulations without constraints
};

/// Invariant I2: the (constrained) Delaunay property under the symbolic perturbation, hull included.
CheckReport checkDelaunay3d(const Triangulation3d& mesh, DelaunayScope scope);

}  // namespace mesher
