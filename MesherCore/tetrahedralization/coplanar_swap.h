#pragma once

#include "delaunay/cavity_retriangulation.h"
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
    CoplanarSwap(Triangulation3d& mesh, FlipSearch& flips) : mesh_(mesh), flips_(flips) {}

    /// The line from `a` to `b` tells the plane that it spans with the edge. False, with nothing changed, if the edge or a face
    /// at it is constrained, or none at it near the plane are a strictly convex quadrilateral.
    bool swap(const std::array<VertexId, 2>& edge, VertexId a, VertexId b);

private:
    bool findPlane(VertexId a, VertexId b);
    bool isDiagonal(std::size_t from, std::size_t to);
    bool fill(std::size_t from, std::size_t to);
    bool fillSide(std::size_t from, std::size_t to);
    bool fillByRing(const std::vector<VertexId>& chain);
    bool findStarPoint(const std::vector<VertexId>& chain, const CavityShell& shell, Vec3& point) const;
    bool fillByStar(const std::vector<VertexId>& chain, std::size_t from, std::size_t to);
    [[nodiscard]] std::array<TetCorners, 2> tetsOn(VertexId p, VertexId q, VertexId r) const;
    [[nodiscard]] bool isPositive(const TetCorners& tet) const;

    Triangulation3d& mesh_;
    FlipSearch& flips_;
    std::array<VertexId, 2> edge_;
    std::vector<TetId> ring_;
    std::vector<VertexId> link_;                         ///< link_[i] and link_[i + 1] are in ring_[i]
    std::array<std::vector<std::size_t>, 2> nearPlane_;  ///< places in the link, by side of the edge
    Vec3 along_;
    Vec3 normal_;
    Vec3 crossing_;  ///< of the diagonals
    std::vector<TetCorners> after_;
    std::vector<VertexId> added_;
};

}  // namespace mesher
