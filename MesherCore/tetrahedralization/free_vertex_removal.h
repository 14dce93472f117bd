#pragma once

#include "delaunay/constrained_tetrahedralization.h"
#include "tetrahedralization/tetrahedralize.h"

#include <cstdint>

namespace mesher {

struct FreeVertexRemoval
{
    std::uint32_t removed = 0;
    std::uint32_t left = 0;  ///< inside of solids
};

/// Removes the vertices inside of solids that are no nodes, scaffold points and those that recovery added, as far as the
/// tetrahedralization stays valid without them. Those outside stay, and scaffold points inside if they are to be Kept.
/// Guarantees   constraints and regions stay; faces that were locally Delaunay stay so
FreeVertexRemoval removeFreeVertices(ConstrainedTetrahedralization& tets, SurfaceScaffold scaffold);

}  // namespace mesher
