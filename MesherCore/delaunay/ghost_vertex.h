#pragma once

#include "base/ids.h"

namespace mesher {

/// The vertex at infinity. It closes the convex hull: every hull edge (or facet) has a ghost simplex on its outer
/// side, so that the hull is no special case of any algorithm. It has no position.
inline constexpr VertexId kGhostVertex{};

}  // namespace mesher
