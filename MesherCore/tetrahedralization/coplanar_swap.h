#pragma once

#include "tetrahedralization/cavity_retriangulation.h"
#include "tetrahedralization/flip_search.h"

#include <array>
#include <vector>

namespace mesher {

/// Replaces an edge by the other diagonal of a strictly convex plane quadrilateral whatever is on both sides of the plane:
/// where the tetrahedra around the edge cannot be put together anew, a vertex is added beside the plane, which always can.
/// Such a vertex lies on no surface, so it can be removed later, or stay.
/// Reference    [george2003] for vertices that are put off the surface so that it stays as it is
class CoplanarSwap
{
public:
    CoplanarSwap(Triangulation3d& mesh, FlipSearch& flips) : mesh_(mesh), flips_(flips), cavities_(mesh) {}

    /// The line from `a` to `b` tells the plane that it spans with the edge. False, with nothing changed, if the edge or a face
    /// at it is constrained, or the faces at it nearest to the plane are no strictly convex quadrilateral near it.
    bool swap(const std::array<VertexId, 2>& edge, VertexId a, VertexId b);

private:
    bool findQuadrilateral(VertexId a, VertexId b);
    bool fillSide(std::size_t from, std::size_t to);
    bool fillByRing(const std::vector<VertexId>& chain);
    bool fillByStar(const std::vector<VertexId>& chain, std::size_t from, std::size_t to);
    [[nodiscard]] std::array<TetCorners, 2> tetsOn(VertexId p, VertexId q, VertexId r) const;
    [[nodiscard]] bool isPositive(const TetCorners& tet) const;

    Triangulation3d& mesh_;
    FlipSearch& flips_;
    CavityRetriangulation cavities_;
    std::array<VertexId, 2> edge_;
    std::vector<TetId> ring_;
    std::vector<VertexId> link_;           ///< link_[i] and link_[i + 1] are in ring_[i]
    std::array<std::size_t, 2> corner_{};  ///< places in the link of the quadrilateral's other corners
    std::vector<TetCorners> after_;
    std::vector<VertexId> added_;
};

}  // namespace mesher
