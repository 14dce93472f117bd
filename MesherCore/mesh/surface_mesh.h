#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/vec.h"
#include "brep/brep_ids.h"
#include "mesh/classified_mesh.h"

#include <array>

namespace mesher {

/// A piece of a model edge's curve between two nodes of a surface mesh.
using SegmentId = Id<struct SegmentTag>;
/// A triangle of a surface mesh, on one face of the model.
using FacetId = Id<struct FacetTag>;

/// Runs along the growing parameter of its edge.
struct SurfaceSegment
{
    std::array<NodeId, 2> node;
    BrepEdgeId edge;
    std::array<double, 2>
        parameter{};  ///< of the ends on the edge; the end of a closed edge is the last of its part

    [[nodiscard]] bool isAlive() const { return edge.isValid(); }
};

/// Counter-clockwise about du x dv of its face's surface. A facet beside a seam has the parameters of one image of the
/// face: they belong together, whatever those of the facet behind the seam are.
struct SurfaceFacet
{
    std::array<NodeId, 3> node;
    BrepFaceId face;
    std::array<Vec2, 3> parameters;

    [[nodiscard]] bool isAlive() const { return face.isValid(); }
};

/// The piecewise linear complex that surfaces hand over to volumes: the sampled curves and faces of a whole model, each
/// segment and facet once, however many faces or solids share it. Ids stay when others are removed: removed ones are not
/// alive.
/// Guarantees   the facets of a face are a 2-manifold whose boundary is the segments of its edges; every model vertex is a
///              node; each node is the exact point of its entity
/// Units        model units
struct SurfaceMesh
{
    IdVector<NodeId, MeshNode> nodes;
    IdVector<SegmentId, SurfaceSegment> segments;
    IdVector<FacetId, SurfaceFacet> facets;
};

}  // namespace mesher
