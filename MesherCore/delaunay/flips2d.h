#pragma once

#include "delaunay/triangulation2d.h"
#include "predicates/static_filter.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// Replaces the diagonal `edge` of its two triangles by the other diagonal. The two triangles keep their ids, and
/// both get a new generation; the region of the triangle of `edge` is given to both.
/// Returns  the new diagonal: edge 0 of the triangle that `edge` was given by, running from the old apex across the
///          edge to the old apex on this side. The old end of `edge` is that triangle's corner 0; the old start is
///          corner 0 of the triangle across, whose edge 0 is the diagonal too
/// Requires an unconstrained edge between two finite triangles that form a strictly convex quadrilateral
EdgeLink flip(Triangulation2d& mesh, EdgeLink edge);

/// Whether the edge is allowed to stay: constrained, on the hull, or locally Delaunay (perturbed, so that exactly
/// one of two diagonals is).
[[nodiscard]] bool isLocallyDelaunay(const Triangulation2d& mesh, const StaticFilter2d& filter,
                                     EdgeLink edge);

/// Flips until every edge is locally Delaunay, starting from the edges in `suspects`, which is emptied. Suspects may
/// be stale: any valid triangle and edge number is fine, as long as all edges in doubt are among them.
/// Guarantees   a constrained Delaunay triangulation, if only the suspects were not locally Delaunay
/// Terminates   always: each flip lowers the lifted surface
/// Cost         linear in the number of flips, which is quadratic at worst
/// Returns      the number of flips
/// Reference    [lawson1977]
std::size_t restoreDelaunay(Triangulation2d& mesh, const StaticFilter2d& filter,
                            std::vector<EdgeLink>& suspects);

}  // namespace mesher
