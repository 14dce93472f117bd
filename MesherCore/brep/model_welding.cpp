#include "brep/model_welding.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

namespace mesher {

namespace {

/// Places that differ by less are one; relative to the model's box, or model units if that is more.
constexpr double kRelativeDistance = 1e-9;
constexpr double kAbsoluteDistance = 1e-7;

/// A parameter curve of an edge, over the parameter of another edge along the same curve.
class CurveOfTwin final : public ParameterCurve
{
public:
    CurveOfTwin(std::shared_ptr<const ParameterCurve> own, const BrepEdge& twin, const BrepEdge& kept,
                bool isOpposite)
        : own_(std::move(own)),
          twin_(twin.curve),
          kept_(kept.curve),
          twinPart_(twin.part),
          keptPart_(kept.part),
          isOpposite_(isOpposite)
    {
    }

    [[nodiscard]] Vec2 position(double t) const override
    {
        if (t == keptPart_.first) return own_->position(isOpposite_ ? twinPart_.last : twinPart_.first);
        if (t == keptPart_.last) return own_->position(isOpposite_ ? twinPart_.first : twinPart_.last);
        return own_->position(twin_->project(kept_->position(t), twinPart_).parameter);
    }
    [[nodiscard]] std::unique_ptr<ParameterCurve> clone() const override
    {
        auto copy = std::make_unique<CurveOfTwin>(*this);
        copy->own_ = own_->clone();
        copy->twin_ = twin_->clone();
        copy->kept_ = kept_->clone();
        return copy;
    }

private:
    std::shared_ptr<const ParameterCurve> own_;
    std::shared_ptr<const Curve> twin_;
    std::shared_ptr<const Curve> kept_;
    Interval twinPart_;
    Interval keptPart_;
    bool isOpposite_;
};

class Welder
{
public:
    explicit Welder(BrepModel& model) : model_(model)
    {
        limit_ = std::max(kAbsoluteDistance, kRelativeDistance * length(model.box.extent()));
        for (std::uint32_t v = 0; v < model.vertices.size(); ++v) welded_.vertex.push_back(BrepVertexId(v));
        for (std::uint32_t e = 0; e < model.edges.size(); ++e) welded_.edge.push_back(BrepEdgeId(e));
        isOpposite_.resize(model.edges.size());
    }

    WeldedEntities run()
    {
        findVertices();
        if (welded_.vertices > 0) moveEnds();
        findEdges();
        if (welded_.edges > 0) replaceEdges();
        return std::move(welded_);
    }

private:
    void findVertices()
    {
        IndexedMap<std::pair<BrepVertexId, BrepVertexId>, bool> joined;
        for (const BrepEdge& edge : model_.edges) joined.insert(unorderedPair(edge.first, edge.last), true);
        std::vector<BrepVertexId> order(model_.vertices.size());
        for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = BrepVertexId(v);
        const auto xOf = [&](BrepVertexId v) { return model_.vertices[v].position.x; };
        std::sort(order.begin(), order.end(), [&](BrepVertexId a, BrepVertexId b) {
            return std::pair(xOf(a), a) < std::pair(xOf(b), b);
        });
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (std::size_t k = i + 1; k < order.size() && xOf(order[k]) - xOf(order[i]) <= limit_; ++k) {
                const auto [low, high] = unorderedPair(order[i], order[k]);
                const Vec3 apart = model_.vertices[high].position - model_.vertices[low].position;
                if (length(apart) > limit_ || joined.contains(std::pair(low, high))) continue;
                weldVertices(welded_.vertex[low], welded_.vertex[high]);
            }
        }
    }

    void weldVertices(BrepVertexId a, BrepVertexId b)
    {
        if (a == b) return;
        const auto [kept, other] = unorderedPair(a, b);
        ++welded_.vertices;
        for (BrepVertexId& v : welded_.vertex) {
            if (v == other) v = kept;
        }
    }

    void moveEnds()
    {
        for (BrepEdge& edge : model_.edges) {
            edge.first = welded_.vertex[edge.first];
            edge.last = welded_.vertex[edge.last];
        }
        for (BrepFace& face : model_.faces) {
            for (BrepVertexId& v : face.embeddedVertices) v = welded_.vertex[v];
        }
    }

    void findEdges()
    {
        IndexedMap<std::pair<BrepVertexId, BrepVertexId>, std::vector<BrepEdgeId>> between;
        for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
            const BrepEdge& edge = model_.edges[BrepEdgeId(e)];
            if (edge.isDegenerate) continue;
            std::vector<BrepEdgeId>& others = between[unorderedPair(edge.first, edge.last)];
            const auto same = std::find_if(others.begin(), others.end(), [&](BrepEdgeId other) {
                return areTwins(other, BrepEdgeId(e)) && !boundOneFace(other, BrepEdgeId(e));
            });
            if (same == others.end()) {
                others.push_back(BrepEdgeId(e));
                continue;
            }
            welded_.edge[BrepEdgeId(e)] = *same;
            isOpposite_[BrepEdgeId(e)] = isOpposite(*same, BrepEdgeId(e)) ? 1 : 0;
            ++welded_.edges;
        }
    }

    [[nodiscard]] bool boundOneFace(BrepEdgeId a, BrepEdgeId b) const
    {
        return std::any_of(model_.faces.begin(), model_.faces.end(), [&](const BrepFace& face) {
            bool hasA = false, hasB = false;
            for (const BrepLoop& loop : face.loops) {
                for (const BrepCoedge& coedge : loop.coedges) {
                    hasA = hasA || coedge.edge == a;
                    hasB = hasB || coedge.edge == b;
                }
            }
            return hasA && hasB;
        });
    }

    /// Places along `other` that lie on `kept`.
    [[nodiscard]] bool areTwins(BrepEdgeId kept, BrepEdgeId other) const
    {
        constexpr std::array<double, 5> kShares{0.5, 0.25, 0.75, 0.1, 0.9};
        const BrepEdge &a = model_.edges[kept], &b = model_.edges[other];
        return std::all_of(kShares.begin(), kShares.end(), [&](double share) {
            const Vec3 onB = b.curve->position(b.part.at(share));
            const Vec3 onA = a.curve->position(a.part.at(share));
            return a.curve->project(onB, a.part).distance <= limit_ &&
                   b.curve->project(onA, b.part).distance <= limit_;
        });
    }

    [[nodiscard]] bool isOpposite(BrepEdgeId kept, BrepEdgeId other) const
    {
        const BrepEdge &a = model_.edges[kept], &b = model_.edges[other];
        if (a.first != a.last) return a.first != b.first;
        const auto placeOn = [&](double share) {
            return b.curve->project(a.curve->position(a.part.at(share)), b.part).parameter;
        };
        return placeOn(0.25) > placeOn(0.75);
    }

    void replaceEdges()
    {
        for (BrepFace& face : model_.faces) {
            for (BrepLoop& loop : face.loops) {
                for (BrepCoedge& coedge : loop.coedges) replace(coedge);
            }
            for (BrepEdgeId& edge : face.embeddedEdges) edge = welded_.edge[edge];
        }
    }

    void replace(BrepCoedge& coedge) const
    {
        const BrepEdgeId kept = welded_.edge[coedge.edge];
        if (kept == coedge.edge) return;
        const bool turns = isOpposite_[coedge.edge] != 0;
        coedge.parameterCurve = std::make_shared<CurveOfTwin>(
            coedge.parameterCurve, model_.edges[coedge.edge], model_.edges[kept], turns);
        coedge.isReversed = coedge.isReversed != turns;
        coedge.edge = kept;
    }

    BrepModel& model_;
    double limit_ = 0.0;
    IdVector<BrepEdgeId, std::uint8_t> isOpposite_;  ///< to the edge that stands for it
    WeldedEntities welded_;
};

}  // namespace

WeldedEntities weldCoincidences(BrepModel& model) { return Welder(model).run(); }

}  // namespace mesher
