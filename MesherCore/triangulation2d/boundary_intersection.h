#pragma once

#include "triangulation2d/boundary.h"
#include "triangulation2d/boundary_index.h"

#include <utility>
#include <vector>

namespace mesher {

/// Whether two segments have a point in common that is not a common end; exact.
[[nodiscard]] bool doSegmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
/// Whether the inner parts of the segments cross; touching at a vertex is no crossing. Exact.
[[nodiscard]] bool doSegmentsCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// The pairs of boundary edges that meet away from a common vertex, also across unmeshed regions; in order of their ids.
/// Cost         O(n log n) where few circles overlap
/// Reference    thesis section 2.4.5, Fig. 2.12
[[nodiscard]] std::vector<std::pair<SubcurveId, SubcurveId>> findIntersections(const Boundary& boundary,
                                                                               const BoundaryIndex& index);

}  // namespace mesher
