#include "brep/planar_domain.h"

#include "brep/curve_crossings.h"
#include "brep/name_list.h"
#include "brep/planarity.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace mesher {

namespace {

Error broken(std::string entity, std::string message, std::optional<Vec3> point, std::string remedy)
{
    return Error{ErrorCode::DegenerateInput, std::move(message), std::move(entity), point, std::move(remedy)};
}

/// The regions beside an edge; both the same for one that lies in a face.
struct EdgeSides
{
    RegionId left{0u};
    RegionId right{0u};
};

class PlanarDomain
{
public:
    PlanarDomain(const BrepModel& model, std::span<const BrepFaceId> faces) : model_(model), faces_(faces) {}

    Result<PlanarCurveComplex> build()
    {
        if (faces_.empty()) {
            return Error{ErrorCode::InvalidArgument, "no face is named", "", {}, "name the faces to mesh"};
        }
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            if (auto added = addFace(i); !added) return added.error();
        }
        if (auto added = addCurves(); !added) return added.error();
        addEmbeddedPoints();
        if (auto simple = refuseCrossing(); !simple) return simple.error();
        return std::move(complex_);
    }

private:
    Result<void> addFace(std::size_t index)
    {
        const BrepFaceId id = faces_[index];
        if (id.value >= model_.faces.size()) {
            return Error{ErrorCode::InvalidArgument,
                         "the model has no such face",
                         nameOf(id),
                         {},
                         "name a face of the model"};
        }
        if (std::find(faces_.begin(), faces_.begin() + static_cast<std::ptrdiff_t>(index), id) !=
            faces_.begin() + static_cast<std::ptrdiff_t>(index)) {
            return Error{
                ErrorCode::InvalidArgument, "the face is named twice", nameOf(id), {}, "name each face once"};
        }
        const Result<PlaneFrame> frame = planeOfFace(model_, id);
        if (!frame) return frame.error();
        if (index == 0) complex_.frame = *frame;
        complex_.regionNames.push_back(nameOf(id));
        if (auto same = refuseOtherPlane(id); !same) return same;
        const bool isTurned = dot(frame.value().normal, complex_.frame.normal) < 0.0;
        const RegionId region(static_cast<std::uint32_t>(index + 1));
        if (auto whole = refuseBadWires(id, isTurned); !whole) return whole;
        return addSides(id, region, isTurned);
    }

    /// Of a face that lies across the plane or beside it; what its edges depart by is refused edge by edge later.
    Result<void> refuseOtherPlane(BrepFaceId id) const
    {
        const BrepFace& face = model_.faces[id];
        double allowed = std::max(face.tolerance, 1e-7);
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges)
                allowed = std::max(allowed, model_.edges[coedge.edge].tolerance);
        }
        double largest = 0.0;
        Vec3 worst;
        for (const Vec3& p : sampleBoundary(model_, face)) {
            const double distance = std::abs(complex_.frame.distanceTo(p));
            if (distance > largest) {
                largest = distance;
                worst = p;
            }
        }
        if (largest <= allowed) return {};
        return broken(nameOf(id),
                      "the face lies in another plane than " + complex_.regionNames.front() +
                          ": its boundary is up to " + roughNumber(largest) + " off that",
                      worst, "mesh the faces of each plane on their own");
    }

    Result<void> refuseBadWires(BrepFaceId id, bool isTurned) const
    {
        const BrepFace& face = model_.faces[id];
        if (face.loops.empty()) return broken(nameOf(id), "the face has no wire", {}, "repair the face");
        double area = 0.0, length_ = 0.0;
        for (const BrepLoop& loop : face.loops) {
            if (loop.coedges.empty())
                return broken(nameOf(id), "a wire of the face is empty", {}, "repair the face");
            if (auto closed = refuseOpenWire(id, loop); !closed) return closed;
            addArea(loop, area, length_);
        }
        if (isTurned) area = -area;
        if (std::abs(area) <= std::max(face.tolerance, 1e-12 * length_) * length_) {
            return broken(nameOf(id),
                          "the face has no area (" + roughNumber(area) +
                              "): its wire runs back on itself or crosses itself",
                          {}, "remove or repair the face");
        }
        if (area < 0.0)
            return broken(nameOf(id), "the wires of the face run the wrong way round", {}, "repair the face");
        return {};
    }

    Result<void> refuseOpenWire(BrepFaceId id, const BrepLoop& loop) const
    {
        for (std::size_t i = 0; i < loop.coedges.size(); ++i) {
            const BrepCoedge& coedge = loop.coedges[i];
            const BrepCoedge& next = loop.coedges[(i + 1) % loop.coedges.size()];
            const BrepEdge& edge = model_.edges[coedge.edge];
            if (!edge.curve) {
                return broken(nameOf(id), nameOf(coedge.edge) + " of its wire has no curve", {},
                              "repair the face");
            }
            const BrepVertexId head = coedge.isReversed ? edge.first : edge.last;
            const BrepEdge& following = model_.edges[next.edge];
            if (head == (next.isReversed ? following.last : following.first)) continue;
            return broken(nameOf(id),
                          "its wire is open between " + nameOf(coedge.edge) + " and " + nameOf(next.edge),
                          model_.vertices[head].position, "close the wire");
        }
        return {};
    }

    /// Signed area in the frame by chords: enough to tell its sign and whether there is any.
    void addArea(const BrepLoop& loop, double& area, double& perimeter) const
    {
        constexpr int kChords = 64;
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model_.edges[coedge.edge];
            const double sign = coedge.isReversed ? -1.0 : 1.0;
            Vec2 before = complex_.frame.toPlane(edge.curve->position(edge.part.first));
            for (int i = 1; i <= kChords; ++i) {
                const Vec2 here = complex_.frame.toPlane(
                    edge.curve->position(edge.part.at(static_cast<double>(i) / kChords)));
                area += 0.5 * sign * cross(before, here);
                perimeter += length(here - before);
                before = here;
            }
        }
    }

    Result<void> addSides(BrepFaceId id, RegionId region, bool isTurned)
    {
        const BrepFace& face = model_.faces[id];
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                EdgeSides& sides = sides_[coedge.edge];
                RegionId& side = coedge.isReversed != isTurned ? sides.right : sides.left;
                if (side != RegionId(0u)) {
                    return broken(nameOf(coedge.edge),
                                  complex_.regionNames[side.value - 1] + " and " + nameOf(id) +
                                      " lie on the same side of it",
                                  {}, "name faces that do not overlap");
                }
                side = region;
            }
        }
        for (const BrepEdgeId edge : face.embeddedEdges) sides_[edge] = {region, region};
        for (const BrepVertexId vertex : face.embeddedVertices) embedded_.push_back({vertex, region});
        return {};
    }

    PccPointId pointOf(BrepVertexId id)
    {
        const auto [entry, isNew] =
            points_.try_emplace(id, static_cast<std::uint32_t>(complex_.points.size()));
        if (isNew) {
            const Vec3 position = model_.vertices[id].position;
            complex_.points.push_back({complex_.frame.toPlane(position), position, id});
        }
        return PccPointId(entry->second);
    }

    Result<void> addCurves()
    {
        std::vector<BrepVertexId> used;
        for (const auto& [id, sides] : sides_) {
            used.push_back(model_.edges[id].first);
            used.push_back(model_.edges[id].last);
        }
        for (const auto& [vertex, region] : embedded_) used.push_back(vertex);
        std::sort(used.begin(), used.end());
        for (const BrepVertexId vertex : used) pointOf(vertex);
        for (const auto& [id, sides] : sides_) {
            const BrepEdge& edge = model_.edges[id];
            if (!edge.curve) return broken(nameOf(id), "the edge has no curve", {}, "repair the face");
            if (auto inPlane = refuseEdgeOffPlane(id); !inPlane) return inPlane;
            complex_.curves.push_back({edge.curve, edge.part, pointOf(edge.first), pointOf(edge.last),
                                       sides.left, sides.right, id});
        }
        return {};
    }

    Result<void> refuseEdgeOffPlane(BrepEdgeId id) const
    {
        constexpr int kSamples = 32;
        const BrepEdge& edge = model_.edges[id];
        double largest = 0.0;
        Vec3 worst;
        for (int i = 0; i <= kSamples; ++i) {
            const Vec3 p = edge.curve->position(edge.part.at(static_cast<double>(i) / kSamples));
            const double distance = std::abs(complex_.frame.distanceTo(p));
            if (distance > largest) {
                largest = distance;
                worst = p;
            }
        }
        const double allowed = std::max(edge.tolerance, 1e-7);
        if (largest <= allowed) return {};
        return broken(nameOf(id),
                      "the edge lies " + roughNumber(largest) + " off the plane of " +
                          complex_.regionNames.front(),
                      worst, "name faces of one plane, or repair the edge");
    }

    void addEmbeddedPoints()
    {
        for (const auto& [vertex, region] : embedded_)
            complex_.embeddedPoints.push_back({pointOf(vertex), region});
    }

    Result<void> refuseCrossing() const
    {
        constexpr double kShareOfSize = 1e-7;
        Box2 box;
        for (const PccPoint& point : complex_.points) box.include(point.position);
        double size = length(box.extent());
        for (const PccCurve& curve : complex_.curves) {
            const Vec3 middle = curve.curve->position(curve.part.at(0.5));
            size = std::max(size, length(middle - complex_.points[curve.first.value].spacePosition));
        }
        const std::optional<CurveCrossing> found = findCurveCrossing(complex_, kShareOfSize * size);
        if (!found) return {};
        const std::string a = nameOf(complex_.curves[found->a.value].edge),
                          b = nameOf(complex_.curves[found->b.value].edge);
        const std::string message =
            a == b ? "the edge meets itself" : "the edges meet away from a common vertex";
        return Error{ErrorCode::IntersectingConstraints, message, a == b ? a : a + " and " + b,
                     complex_.frame.toSpace(found->position),
                     "split them at a common vertex or move them apart"};
    }

    const BrepModel& model_;
    std::span<const BrepFaceId> faces_;
    PlanarCurveComplex complex_;
    std::map<BrepEdgeId, EdgeSides> sides_;
    std::map<BrepVertexId, std::uint32_t> points_;
    std::vector<std::pair<BrepVertexId, RegionId>> embedded_;
};

}  // namespace

Result<PlanarCurveComplex> planarCurveComplex(const BrepModel& model, std::span<const BrepFaceId> faces)
{
    return PlanarDomain(model, faces).build();
}

}  // namespace mesher
