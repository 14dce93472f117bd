#pragma once

#include "base/budget.h"
#include "base/result.h"
#include "triangulation2d/boundary.h"

#include <cstddef>

namespace mesher {

struct BoundaryEnrichment2d
{
    std::size_t splits = 0;
    /// Edges that still met others after Algorithm 2.1 had ended, and were split for it.
    std::size_t intersectionSplits = 0;
};

/// Splits subcurves until every boundary edge is constrained Delaunay: no visible vertex in its diametral circle. Then
/// the Delaunay triangulation of the vertices can be constrained to the edges by flips alone.
/// Guarantees   no two boundary edges meet away from a common vertex, verified exactly; each vertex lies on the same side
///              of an edge as of its subcurve
/// Refuses      curves that meet away from a common point, told when the edges have become too short to be split
/// Terminates   where small angles are protected (small_angles2d.h) and curves do not meet; the budget ends it earlier
/// Cost         O(n log n) with an R-tree
/// Reference    thesis Algorithms 2.1 and 2.2, [gosselin]
[[nodiscard]] Result<BoundaryEnrichment2d> enrichBoundary(const PlanarDomain& domain, Boundary& boundary,
                                                          Budget& budget);

}  // namespace mesher
