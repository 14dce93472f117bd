#pragma once

#include "delaunay/triangulation2d.h"

#include <cstdint>

namespace mesher {

/// A number that tells triangulations apart by their vertices' coordinates, finite triangles and constrained edges,
/// whatever the numbering of vertices and triangles: equal triangulations have equal hashes on every platform.
[[nodiscard]] std::uint64_t meshHash2d(const Triangulation2d& mesh);

}  // namespace mesher
