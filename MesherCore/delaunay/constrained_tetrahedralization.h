#pragma once

#include "base/id_vector.h"
#include "base/indexed_map.h"
#include "delaunay/delaunay3d.h"
#include "mesh/surface_mesh.h"

#include <array>
#include <memory>
#include <utility>

namespace mesher {

/// A tetrahedralization with the segments and facets of a surface mesh as constraints, as it goes from recovery through
/// refinement to improvement. Tetrahedra outside of all solids are kept, with region 0; the region of solid i is i + 1.
/// Guarantees   each live segment is a constrained edge and each live facet a constrained face, and there are no others;
///              the maps say which
struct ConstrainedTetrahedralization
{
    std::unique_ptr<Delaunay3d> delaunay;
    /// Coordinates of the tetrahedralization are those of the model times this power of two.
    double scale = 1.0;
    /// The node of the surface mesh at a vertex; invalid inside of a solid.
    IdVector<VertexId, NodeId> nodeOf;
    IdVector<NodeId, VertexId> vertexOf;
    /// By the ends of the edge, the smaller id first.
    IndexedMap<std::pair<VertexId, VertexId>, SegmentId> segmentOf;
    /// By the corners of the face, ascending.
    IndexedMap<std::array<VertexId, 3>, FacetId> facetOf;

    [[nodiscard]] const Triangulation3d& mesh() const { return delaunay->triangulation(); }
    [[nodiscard]] Triangulation3d& mesh() { return delaunay->triangulation(); }
};

}  // namespace mesher
