#pragma once

#include "improvement/local_change.h"

namespace mesher {

/// Finds the neighbour that a node inside of a solid is best drawn into.
/// Guarantees   false unless all tetrahedra that change stay positive and the least score at the node rises; edges get no longer
///              than 1.3 times the longest at the node; nodes of the boundary stay where they are
/// Cost         a score for each tetrahedron and neighbour of the node, most of them spared by the first bad one
[[nodiscard]] bool evaluateContraction(const TetComplex& complex, NodeId node, LocalChange& change);

}  // namespace mesher
