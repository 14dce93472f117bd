#include "triangulation2d/constrained_delaunay2d.h"

#include <string>
#include <vector>

namespace mesher {
namespace {

constexpr RegionId kUnclassified{RegionId::kInvalid};

class Construction
{
public:
    Construction(const PlanarDomain& domain, RunContext& context, PlanarTriangulation& triangulation)
        : domain_(domain), context_(context), t_(triangulation)
    {
    }

    Result<void> run()
    {
        // What has ended the run leaves vertices and edges out that the next step counts on.
        if (auto inserted = insertVertices(); !inserted || isStopped_) return inserted;
        if (auto constrained = constrainEdges(); !constrained || isStopped_) return constrained;
        return classify();
    }

private:
    Result<void> insertVertices()
    {
        std::vector<Vec2> points;
        points.reserve(t_.boundary.vertices.size());
        for (const BoundaryVertex& vertex : t_.boundary.vertices) points.push_back(vertex.position);
        auto inserted = t_.delaunay.insertPoints(points, &context_);
        if (!inserted) return inserted.error();
        isStopped_ = inserted->stopReason != StopReason::Done;
        if (isStopped_) return {};
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            const VertexId v = inserted->vertices[i];
            if (t_.mesh().origin(v) != VertexOrigin::Unset) return coincidence(BoundaryVertexId(i), v);
            BoundaryVertex& vertex = t_.boundary.vertices[BoundaryVertexId(i)];
            vertex.vertex = v;
            t_.delaunay.setOrigin(v, vertex.point.isValid() ? VertexOrigin::Corner : VertexOrigin::Curve, i);
        }
        if (t_.delaunay.dimension() == 2) return {};
        Error error;
        error.code = ErrorCode::DegenerateInput;
        error.entity = "domain";
        error.message = "all curves lie on one line";
        error.remedy = "give curves that bound a region";
        return error;
    }

    Result<void> constrainEdges()
    {
        for (std::uint32_t i = 0; i < t_.boundary.subcurves.size(); ++i) {
            const SubcurveId s(i);
            if (!t_.boundary.subcurves[s].isAlive) continue;
            isStopped_ = !context_.mayGoOn();
            if (isStopped_) return {};
            auto recovered = t_.delaunay.recoverSegment(t_.firstVertex(s), t_.lastVertex(s));
            if (!recovered) return recovered.error();
            MESHER_INVARIANT(t_.delaunay.lastSegment().size() == 2);
            t_.subcurveOfEdge.insert(unorderedPair(t_.firstVertex(s), t_.lastVertex(s)), s);
        }
        return {};
    }

    Result<void> classify()
    {
        for (std::uint32_t i = 0; i < t_.mesh().triangleSlots(); ++i) {
            if (t_.mesh().isAlive(TriangleId(i))) t_.delaunay.setRegion(TriangleId(i), kUnclassified);
        }
        for (std::uint32_t i = 0; i < t_.mesh().triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!t_.mesh().isAlive(t) || !t_.mesh().triangle(t).isGhost()) continue;
            if (!flood(t, RegionId(0))) return contradiction(t_.mesh().triangle(t).v[0]);
        }
        for (std::uint32_t i = 0; i < t_.boundary.subcurves.size(); ++i) {
            const SubcurveId s(i);
            if (!t_.boundary.subcurves[s].isAlive) continue;
            const PccCurve& curve = domain_.curve(t_.boundary.subcurves[s].curve);
            const EdgeLink side = t_.mesh().findEdge(t_.firstVertex(s), t_.lastVertex(s));
            if (!flood(side.triangle(), curve.left) ||
                !flood(t_.mesh().across(side).triangle(), curve.right)) {
                return contradiction(t_.firstVertex(s));
            }
        }
        return {};
    }

    /// False if a triangle that is reached has another region already.
    bool flood(TriangleId start, RegionId region)
    {
        stack_.assign(1, start);
        while (!stack_.empty()) {
            const TriangleId t = stack_.back();
            stack_.pop_back();
            const Triangle2d& record = t_.mesh().triangle(t);
            if (record.region == region) continue;
            if (record.region != kUnclassified) return false;
            t_.delaunay.setRegion(t, region);
            for (unsigned edge = 0; edge < 3; ++edge) {
                if (!record.isConstrained(edge)) stack_.push_back(record.n[edge].triangle());
            }
        }
        return true;
    }

    [[nodiscard]] Error contradiction(VertexId near) const
    {
        Error error;
        error.code = ErrorCode::InvalidArgument;
        error.entity = "regions";
        error.message =
            "the curves contradict each other about the region on their sides, or do not close it";
        error.point = t_.boundary.vertices[t_.boundaryVertexOf(near)].space;
        error.remedy = "close the region's boundary and give it the same region on the inner side all along";
        return error;
    }

    [[nodiscard]] Error coincidence(BoundaryVertexId b, VertexId v) const
    {
        const auto nameOf = [&](BoundaryVertexId id) {
            const BoundaryVertex& vertex = t_.boundary.vertices[id];
            return vertex.point.isValid() ? domain_.nameOf(vertex.point) : domain_.nameOf(vertex.curve);
        };
        Error error;
        error.code = ErrorCode::DuplicatePoint;
        error.entity = nameOf(t_.boundaryVertexOf(v)) + " and " + nameOf(b);
        error.message = "they meet, but have no point in common";
        error.point = t_.boundary.vertices[b].space;
        error.remedy = "make the two points one and split curves there";
        return error;
    }

    const PlanarDomain& domain_;
    RunContext& context_;
    PlanarTriangulation& t_;
    std::vector<TriangleId> stack_;
    bool isStopped_ = false;
};

}  // namespace

Result<void> buildConstrainedDelaunay(const PlanarDomain& domain, RunContext& context,
                                      PlanarTriangulation& triangulation)
{
    return Construction(domain, context, triangulation).run();
}

}  // namespace mesher
