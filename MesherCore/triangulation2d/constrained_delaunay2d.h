#pragma once

#include "base/result.h"
#include "base/run_context.h"
#include "triangulation2d/planar_triangulation.h"

namespace mesher {

/// Builds the constrained Delaunay triangulation of the boundary's vertices and edges, by flips alone, and gives each
/// triangle its region by flooding from the curves' sides.
/// Requires     an enriched boundary (boundary_enrichment.h)
/// Refuses      points that coincide; curves that do not close a region or contradict each other about it
/// Cost         O(n log n)
/// Reference    thesis section 2.4.2
[[nodiscard]] Result<void> buildConstrainedDelaunay(const PlanarDomain& domain, RunContext& context,
                                                    PlanarTriangulation& triangulation);

}  // namespace mesher
