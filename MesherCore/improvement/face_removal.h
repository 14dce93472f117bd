#pragma once

#include "improvement/local_change.h"

namespace mesher {

/// Finds the best way to do without a face and with an edge between the two nodes opposite to it: faces beside it that lie between
/// the same two nodes may go with it (multi-face removal, the reverse of edge removal; a single face is the 2-3 flip).
/// Guarantees   false unless all new tetrahedra are positive and the least score rises, above the floor; nothing of the boundary is changed
/// Cost         a few scores for each face that goes, 6 at the most
/// Reference    [shewchuk2002b]
[[nodiscard]] bool evaluateFaceRemoval(const TetComplex& complex, TetId tet, std::size_t opposite,
                                       double floor, LocalChange& change);

}  // namespace mesher
