#pragma once

#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_mesh.h"
#include "mesh/surface_splitter.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace mesher::test {

/// What a sampled solid knows of its exact geometry.
struct SolidGeometry
{
    std::vector<std::function<Vec3(const Vec3&)>> faces;  ///< closest point, by face
    std::vector<std::function<Vec3(const Vec3&)>> edges;  ///< closest point, by edge
    /// Faces that a point of the initial sample lies on, ascending.
    std::function<std::vector<std::uint32_t>(const Vec3&)> facesAt;
    /// The edge between two faces.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edgeBetween;
    /// Whether a point is inside; null for a convex solid, which is the hull of its sample.
    std::function<bool(const Vec3&)> isInside;
};

/// Splits facets and segments of a sampled solid on its exact geometry, by conflict regions on the facets of one face.
class SampledSplitter final : public SurfaceSplitter
{
public:
    SampledSplitter(SurfaceMesh mesh, std::shared_ptr<const SolidGeometry> geometry, double floor);

    [[nodiscard]] const SurfaceMesh& mesh() const override { return mesh_; }
    void evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    void evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    [[nodiscard]] bool accepts(const SurfaceSplit& /*split*/) const override { return true; }
    SurfaceSplitResult commit(const SurfaceSplit& split) override;
    [[nodiscard]] bool maySwap(FacetId first, FacetId second) const override;
    std::array<FacetId, 2> swap(FacetId first, FacetId second) override;

private:
    using Side = std::pair<NodeId, NodeId>;

    [[nodiscard]] Vec3 position(NodeId node) const { return mesh_.nodes[node].position; }
    [[nodiscard]] Vec3 normalOf(const SurfaceFacet& facet) const;
    [[nodiscard]] bool isInBall(const SurfaceFacet& facet, const Vec3& point) const;
    [[nodiscard]] FacetId behind(FacetId facet, NodeId a, NodeId b) const;
    [[nodiscard]] SegmentId segmentAt(NodeId a, NodeId b) const;
    FacetId walk(FacetId from, const Vec3& point, SurfaceSplit& split) const;
    void growPatch(FacetId seed, const Vec3& point, SegmentId across, SurfaceSplitExtent extent,
                   std::vector<FacetId>& patch) const;
    bool addStar(const std::vector<FacetId>& patch, SegmentId across, SurfaceSplit& split) const;
    void attach(FacetId facet, bool isAttached);

    SurfaceMesh mesh_;
    std::shared_ptr<const SolidGeometry> geometry_;
    double floor_;
    std::map<Side, std::vector<FacetId>> facetsAt_;
    std::map<Side, SegmentId> segmentsAt_;
};

/// A solid with its surface sample as constraints of a Delaunay tetrahedralization.
struct SampledSolid
{
    std::shared_ptr<const SolidGeometry> geometry;
    std::unique_ptr<SampledSplitter> splitter;
    ConstrainedTetrahedralization tetrahedralization;
    double volume = 0.0;  ///< exact
};

/// The sample must have all facets of the surface in its Delaunay tetrahedralization.
SampledSolid makeSampledSolid(const std::vector<Vec3>& points, SolidGeometry geometry, double volume,
                              double scale = 1.0);

/// A box with `cells` cells a side on each face.
SampledSolid sampledBox(const Vec3& size, std::uint32_t cells, double scale = 1.0);
/// A plate with `cells` cells a side on its two faces and one across.
SampledSolid sampledPlate(double width, double thickness, std::uint32_t cells);
/// A triangular prism with a right angle: legs `width` and `height`, `length` long, `cells` cells along the length. The
/// angle between its base and its slope is atan(height / width).
SampledSolid sampledWedge(double width, double height, double length, std::uint32_t cells);
/// `count` points in a spiral.
SampledSolid sampledSphere(double radius, std::uint32_t count, double scale = 1.0);
/// `around` points on each of its two circles.
SampledSolid sampledCylinder(double radius, double height, std::uint32_t around, double scale = 1.0);
SampledSolid sampledTorus(double ringRadius, double tubeRadius, std::uint32_t around, double scale = 1.0);

}  // namespace mesher::test
