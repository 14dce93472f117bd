#pragma once

#include "delaunay/id_set.h"
#include "delaunay/triangulation3d.h"
#include "predicates/sign.h"

#include <array>
#include <vector>

namespace mesher {

/// The edges and tetrahedra that a triangle passes through.
struct FacetCrossing
{
    /// Each from the negative to the positive side of the triangle.
    std::vector<std::array<VertexId, 2>> edges;
    /// In the order in which they were come to.
    std::vector<TetId> tets;
    /// A vertex that lies on the triangle; invalid if there is none, and nothing else counts if there is one.
    VertexId touching;
};

/// Finds what a triangle passes through, exactly.
class FacetCrossings
{
public:
    explicit FacetCrossings(const Triangulation3d& mesh) : mesh_(mesh) {}

    /// Fills `crossing`; it has no edges if the triangle is a face.
    /// Requires  the edges of the triangle in the tetrahedralization, and all tetrahedra around its inside finite
    void find(const std::array<VertexId, 3>& facet, FacetCrossing& crossing);

    /// +1, 0 or -1: where the vertex lies about the plane of the triangle; positive where it turns counter-clockwise.
    [[nodiscard]] Sign sideOf(VertexId vertex) const;

private:
    bool visit(TetId tet, FacetCrossing& crossing);
    [[nodiscard]] bool isPierced(VertexId low, VertexId high) const;
    [[nodiscard]] bool isInside(VertexId coplanar) const;

    const Triangulation3d& mesh_;
    std::array<VertexId, 3> facet_;
    IdSet visited_;
    std::vector<TetId> ring_;
};

}  // namespace mesher
