#pragma once

#include "base/id_vector.h"
#include "brep/brep_model.h"
#include "mesh/surface_mesh.h"
#include "surface_sampling/face_mesh.h"
#include "surface_sampling/surface_refinement.h"

#include <cstddef>
#include <vector>

namespace mesher::test {

/// A face with facets made by hand.
struct FaceExample
{
    BrepFace face;
    IdVector<NodeId, MeshNode> nodes;
    std::vector<SurfaceFacet> facets;
    SegmentsByEnds segments;

    [[nodiscard]] Result<FaceMesh> mesh(const FaceGeometry& geometry) const
    {
        return FaceMesh::make(BrepFaceId(0), geometry, facets, nodes, segments);
    }
};

/// Whether the grid comes round to its start in a direction: then it ends one period on, and has no border there.
struct GridClosure
{
    bool isClosedU = false;
    bool isClosedV = false;
};

/// Cells of equal parameters, each cut into two facets; the border's sides are segments.
[[nodiscard]] FaceExample gridFace(std::shared_ptr<const Surface> surface, Interval u, Interval v,
                                   std::size_t cellsU, std::size_t cellsV, GridClosure closure = {});
/// Eight facets on a whole sphere; its poles are the nodes 0 and 1, the seam is crossed by facets.
[[nodiscard]] FaceExample octahedronOnSphere(double radius);
/// A wavy bicubic B-spline over a square of side 4.
[[nodiscard]] std::shared_ptr<const Surface> wavySpline();

/// A boundary that is never split.
class FrozenBoundary final : public FaceBoundary
{
public:
    [[nodiscard]] bool maySplit(SegmentId) const override { return false; }
    [[nodiscard]] bool isAtApex(SegmentId) const override { return false; }
    [[nodiscard]] bool spansSmallAngle(NodeId, NodeId) const override { return false; }
    [[nodiscard]] BrepEdgeId edgeOf(SegmentId) const override { return {}; }
    [[nodiscard]] double wholeLengthOf(SegmentId) const override { return 0.0; }
};

/// Over all facets, degrees.
[[nodiscard]] double smallestAngle(const FaceMesh& mesh);
[[nodiscard]] double longestEdge(const FaceMesh& mesh);
[[nodiscard]] double areaOf(const FaceMesh& mesh);

}  // namespace mesher::test
