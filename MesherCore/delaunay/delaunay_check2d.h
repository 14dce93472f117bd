#pragma once

#include "delaunay/triangulation2d.h"

#include <cstddef>
#include <string>

namespace mesher {

/// What a checker found: nothing, or the first violation.
struct CheckReport2d
{
    std::string violation;  ///< empty if all is well
    std::size_t finiteTriangles = 0;
    std::size_t hullEdges = 0;
    std::size_t constrainedEdges = 0;

    [[nodiscard]] bool isClean() const { return violation.empty(); }
};

/// Links and constraint flags symmetric, ghosts consistent, each finite triangle positively oriented, the hull convex,
/// every vertex in the triangle it names, Euler's relation.
/// Cost  linear
[[nodiscard]] CheckReport2d checkTopology(const Triangulation2d& mesh);

/// checkTopology, and every unconstrained edge locally Delaunay: with it the triangulation is the constrained
/// Delaunay triangulation, the unique one under the symbolic perturbation.
/// Cost  linear
[[nodiscard]] CheckReport2d checkDelaunay(const Triangulation2d& mesh);

/// No vertex inside of any triangle's circle, by brute force and without the perturbation; for triangulations without
/// constrained edges.
/// Cost  triangles times vertices
[[nodiscard]] CheckReport2d checkEmptyCircles(const Triangulation2d& mesh);

}  // namespace mesher
