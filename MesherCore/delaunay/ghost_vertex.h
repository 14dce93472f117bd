#pragma once

#include "base/ids.h"

namespace mesher {

/// The vertex at infinity that every hull facet (3D) or hull edge (2D) is joined to, so that the hull is no
/// special case: each simplex has all its neighbours. It has no point and stands in the last slot of its simplices.
inline constexpr VertexId kGhostVertex{};

constexpr bool isGhost(VertexId vertex) { return vertex == kGhostVertex; }

}  // namespace mesher
