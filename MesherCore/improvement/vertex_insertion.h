#pragma once

#include "improvement/local_change.h"
#include "improvement/vertex_smoothing.h"

#include <vector>

namespace mesher {

/// Finds the best cavity about a tetrahedron to be replaced by the star of a new node inside, and the best place of that: the
/// tetrahedra around one of its edges, it and those behind one of its faces, or behind all. Where all nodes are on the boundary,
/// as in thin walls, nothing else may help.
/// Guarantees   false unless all new tetrahedra are positive and the least score rises, above the floor; nothing of the boundary
///              is changed
/// Cost         the smoothing of a node for each of up to eleven cavities
/// Reference    [klingner2007] inserts into larger cavities
class VertexInsertion
{
public:
    VertexInsertion(const TetComplex& complex, VertexSmoothing& smoothing)
        : complex_(complex), smoothing_(smoothing)
    {
    }

    [[nodiscard]] bool evaluate(TetId tet, double floor, double target, LocalChange& change);

private:
    void collectAround(NodeId a, NodeId b);
    void collectBehind(TetId tet, std::size_t first, std::size_t last);
    bool findHull();
    void collectEnclosed(std::vector<NodeId>& enclosed) const;
    void tryCavity(double target, LocalChange& change);

    const TetComplex& complex_;
    VertexSmoothing& smoothing_;
    std::vector<TetId> cavity_;
    std::vector<FacetNodes> hull_;  ///< each counter-clockwise as seen from inside
};

}  // namespace mesher
