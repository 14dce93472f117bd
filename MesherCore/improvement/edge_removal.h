#pragma once

#include "improvement/local_change.h"

namespace mesher {

/// The most tetrahedra around an edge, on one side of the boundary, with which it is removed.
inline constexpr std::size_t kMostAroundEdge = 12;

/// Whether edges of the boundary take part.
enum class BoundaryChanges
{
    None,
    Allowed
};

struct EdgeRemovalLimits
{
    BoundaryChanges boundary = BoundaryChanges::Allowed;
    double floor = 0.0;  ///< scores up to here are of no use
};

/// Finds the best way to do without an edge: its n tetrahedra give way to the 2n - 4 whose least score is largest, by Klincsek's
/// dynamic programme over the triangulations of the polygon around it. An edge of the boundary is swapped along: the two
/// triangles beside it, of one face, become the two on the other diagonal, and the polygons on both sides are triangulated. A
/// tetrahedron with both triangles is taken off.
/// Guarantees   false unless all new tetrahedra are positive and the least score rises, above the floor; of the boundary only what BoundaryGeometry
///              allows is changed, and no line, face or solid loses its topology
/// Cost         n^3 / 6 pairs of scores
/// Reference    [klincsek1980] [freitag1997]
[[nodiscard]] bool evaluateEdgeRemoval(const TetComplex& complex, BoundaryGeometry& geometry, NodeId a,
                                       NodeId b, const EdgeRemovalLimits& limits, LocalChange& change);

}  // namespace mesher
