#pragma once

#include "brep/brep_model.h"

#include <vector>

namespace mesher {

/// Coedges of one wire put head to tail.
struct OrderedWire
{
    std::vector<BrepLoop> loops;             ///< one, unless the wire touches itself in several loops
    std::vector<BrepVertexId> openVertices;  ///< where no coedge goes on
};

/// Orders by vertices; where several coedges leave a vertex, by the nearest start of the parameter curve, which keeps the two
/// uses of a seam apart.
[[nodiscard]] OrderedWire orderWire(const BrepModel& model, std::vector<BrepCoedge> coedges);

}  // namespace mesher
