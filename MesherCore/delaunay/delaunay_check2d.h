#pragma once

#include "delaunay/check_report.h"
#include "delaunay/triangulation2d.h"

namespace mesher {

/// Links and constraint flags symmetric, ghosts consistent, each finite triangle positively oriented, the hull convex,
/// every vertex in the triangle it names, Euler's relation.
/// Cost  linear
[[nodiscard]] CheckReport checkTopology2d(const Triangulation2d& mesh);

/// checkTopology2d, and every unconstrained edge locally Delaunay: with it the triangulation is the constrained
/// Delaunay triangulation, the unique one under the symbolic perturbation.
/// Cost  linear
[[nodiscard]] CheckReport checkDelaunay2d(const Triangulation2d& mesh);

/// No vertex inside of any triangle's circle, by brute force and without the perturbation; for triangulations without
/// constrained edges.
/// Cost  triangles times vertices
[[nodiscard]] CheckReport checkEmptyCircles2d(const Triangulation2d& mesh);

}  // namespace mesher
