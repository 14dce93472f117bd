#include "pipeline/plane_faces.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace mesher {

namespace {

/// Faces whose planes differ by more than this part of the model's size, or by more than their tolerance, are not coplanar.
constexpr double kPlaneTolerance = 1e-9;

class ComplexBuilder
{
public:
    explicit ComplexBuilder(const BrepModel& model) : model_(model) {}

    Result<PlanarCurveComplex> build()
    {
        if (model_.faces.empty()) {
            return Error{ErrorCode::DegenerateInput, "has no faces to mesh", "model", {}, "make a face from the wires"};
        }
        for (std::uint32_t i = 0; i < model_.faces.size(); ++i) {
            if (auto added = addFace(BrepFaceId(i)); !added) return added.error();
        }
        return std::move(complex_);
    }

private:
    Result<void> addFace(BrepFaceId id)
    {
        const BrepFace& face = model_.faces[id];
        const std::optional<PlaneFrame> frame = face.surface->planeFrame();
        if (!frame) {
            return Error{ErrorCode::InvalidArgument, "is not plane", nameOf(id), {},
                         "mesh plane faces only, or the solid with --dimension 3"};
        }
        if (complex_.regionNames.empty()) complex_.frame = *frame;
        if (!isInPlane(*frame, face.tolerance)) {
            return Error{ErrorCode::InvalidArgument, "lies in another plane than Face1", nameOf(id), frame->origin,
                         "mesh the faces of each plane on their own, or the solid with --dimension 3"};
        }
        complex_.regionNames.push_back(nameOf(id));
        const RegionId region(static_cast<std::uint32_t>(complex_.regionNames.size()));
        const bool isFlipped = dot(frame->normal, complex_.frame.normal) < 0.0;
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                if (auto added = addSide(coedge, region, isFlipped); !added) return added;
            }
        }
        for (const BrepEdgeId edge : face.embeddedEdges) {
            PccCurve& curve = curveOf(edge);
            curve.left = region;
            curve.right = region;
        }
        for (const BrepVertexId vertex : face.embeddedVertices) {
            complex_.embeddedPoints.push_back({pointOf(vertex), region});
        }
        return {};
    }

    [[nodiscard]] bool isInPlane(const PlaneFrame& frame, double tolerance) const
    {
        const double size = length(model_.box.extent());
        const bool isParallel = length(cross(frame.normal, complex_.frame.normal)) <= kPlaneTolerance;
        return isParallel && std::abs(complex_.frame.distanceTo(frame.origin)) <= std::max(kPlaneTolerance * size, tolerance);
    }

    /// The face lies to the left of a coedge that runs along the loop in the face's own frame.
    Result<void> addSide(const BrepCoedge& coedge, RegionId region, bool isFlipped)
    {
        if (model_.edges[coedge.edge].isDegenerate) return {};
        PccCurve& curve = curveOf(coedge.edge);
        const bool isLeft = coedge.isReversed == isFlipped;
        RegionId& side = isLeft ? curve.left : curve.right;
        if (side.value != 0) {
            return Error{ErrorCode::IntersectingConstraints, "two faces lie on the same side of it", nameOf(coedge.edge), {},
                         "remove one of the overlapping faces"};
        }
        side = region;
        return {};
    }

    PccCurve& curveOf(BrepEdgeId id)
    {
        if (const std::uint32_t* found = curveIndex_.find(id)) return complex_.curves[*found];
        const BrepEdge& edge = model_.edges[id];
        curveIndex_.insert(id, static_cast<std::uint32_t>(complex_.curves.size()));
        PccCurve curve;
        curve.curve = edge.curve;
        curve.part = edge.part;
        curve.first = pointOf(edge.first);
        curve.last = pointOf(edge.last);
        curve.edge = id;
        complex_.curves.push_back(std::move(curve));
        return complex_.curves.back();
    }

    PccPointId pointOf(BrepVertexId id)
    {
        if (const std::uint32_t* found = pointIndex_.find(id)) return PccPointId(*found);
        const auto index = static_cast<std::uint32_t>(complex_.points.size());
        pointIndex_.insert(id, index);
        const Vec3& position = model_.vertices[id].position;
        complex_.points.push_back({complex_.frame.toPlane(position), position, id});
        return PccPointId(index);
    }

    const BrepModel& model_;
    PlanarCurveComplex complex_;
    IndexedMap<BrepEdgeId, std::uint32_t> curveIndex_;
    IndexedMap<BrepVertexId, std::uint32_t> pointIndex_;
};

}  // namespace

Result<PlanarCurveComplex> complexOfPlaneFaces(const BrepModel& model) { return ComplexBuilder(model).build(); }

}  // namespace mesher
