#pragma once

#include "delaunay/triangulation3d.h"

namespace mesher {

/// Whether a tetrahedron is one of a solid: neither removed, nor outside, nor beyond the hull.
[[nodiscard]] inline bool isMeshed(const Triangulation3d& mesh, TetId tet)
{
    return mesh.isAlive(tet) && mesh.region(tet) != kExteriorRegion && !mesh.isGhostTet(tet);
}

}  // namespace mesher
