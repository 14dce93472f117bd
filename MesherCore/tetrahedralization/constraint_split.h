#pragma once

#include "delaunay/tet_replacement3d.h"
#include "tetrahedralization/edge_crossing.h"
#include "tetrahedralization/facet_crossing.h"
#include "tetrahedralization/surface_constraints.h"

#include <vector>

namespace mesher {

/// Splits constraints that could not be recovered as they are, and inserts the new vertex.
/// Reference    [gosselin] §3.3.3 "Edge Recovery by Insertion"; [george1991] for points where a constraint crosses the mesh
class ConstraintSplit
{
public:
    explicit ConstraintSplit(SurfaceConstraints& constraints)
        : constraints_(constraints), replacement_(constraints.mesh())
    {
    }

    /// At a point that the splitter offers; None if it offers none that can be inserted.
    bool splitEdgeExactly(VertexId a, VertexId b);
    bool splitFacetExactly(FacetId facet);
    /// Where the edge passes through a face or an edge, the middle one first: with each such point the rest of the edge
    /// passes through less.
    bool splitEdgeAtCrossing(VertexId a, VertexId b, const std::vector<EdgeCrossing>& crossings);
    /// Where an edge crosses the facet.
    bool splitFacetAtCrossing(FacetId facet, const FacetCrossing& crossing);
    /// At a vertex that lies on the edge or facet.
    void splitEdgeAt(VertexId a, VertexId b, VertexId vertex);
    void splitFacetAt(FacetId facet, VertexId vertex);

private:
    bool insertAndMake(const SurfaceSplit& split);
    bool makeReady(SurfaceSplit& split);
    VertexId insertStar(const Vec3& point);
    [[nodiscard]] SurfaceSplit describeEdgeSplit(VertexId a, VertexId b, const Vec3& kernelPoint);
    [[nodiscard]] SurfaceSplit describeFacetSplit(FacetId facet, const Vec3& kernelPoint) const;

    SurfaceConstraints& constraints_;
    TetReplacement3d replacement_;
    std::vector<TetId> tets_;
    std::vector<TetCorners> star_;
    SurfaceSplit split_;
};

}  // namespace mesher
