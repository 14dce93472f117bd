#pragma once

#include "base/indexed_map.h"
#include "delaunay/delaunay2d.h"
#include "triangulation2d/boundary.h"
#include "triangulation2d/small_angles2d.h"

#include <utility>

namespace mesher {

/// A triangulation of a planar domain and what its entities lie on. Triangles outside of the domain and in holes are kept,
/// with region 0, so that no operation meets the end of the mesh.
struct PlanarTriangulation
{
    Delaunay2d delaunay;
    Boundary boundary;
    SmallAngles2d smallAngles;
    /// The subcurve of each constrained edge.
    IndexedMap<std::pair<VertexId, VertexId>, SubcurveId> subcurveOfEdge;
    /// Triangulation coordinates are those of the plane times this power of two.
    double scale = 1.0;

    [[nodiscard]] const Triangulation2d& mesh() const { return delaunay.mesh(); }
    /// Invalid for vertices inside of a region.
    [[nodiscard]] BoundaryVertexId boundaryVertexOf(VertexId v) const
    {
        return mesh().origin(v) == VertexOrigin::Face ? BoundaryVertexId()
                                                      : BoundaryVertexId(mesh().entity(v));
    }
    [[nodiscard]] VertexId firstVertex(SubcurveId s) const
    {
        return boundary.vertices[boundary.subcurves[s].first].vertex;
    }
    [[nodiscard]] VertexId lastVertex(SubcurveId s) const
    {
        return boundary.vertices[boundary.subcurves[s].last].vertex;
    }
    [[nodiscard]] SubcurveId subcurveOf(VertexId a, VertexId b) const
    {
        const SubcurveId* found = subcurveOfEdge.find(unorderedPair(a, b));
        return found == nullptr ? SubcurveId() : *found;
    }
    [[nodiscard]] SubcurveId subcurveOf(EdgeLink edge) const
    {
        return subcurveOf(mesh().edgeFrom(edge), mesh().edgeTo(edge));
    }
    [[nodiscard]] bool isMeshed(TriangleId t) const
    {
        return !mesh().triangle(t).isGhost() && mesh().triangle(t).region.value != 0;
    }
};

}  // namespace mesher
