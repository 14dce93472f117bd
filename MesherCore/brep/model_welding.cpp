#include "brep/model_welding.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
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

    Welder(BrepModel& model, WeldingScope scope) : Welder(model)
    {
        scope_ = std::move(scope);
        limit_ = scope_->distance;
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
    [[nodiscard]] bool mayWeld(BrepEdgeId e) const { return !scope_ || scope_->mayWeld[e] != 0; }

    /// How far apart two entities of these tolerances may be.
    [[nodiscard]] double limitFor(double toleranceA, double toleranceB) const
    {
        return scope_ ? std::max(limit_, std::min(toleranceA + toleranceB, scope_->most)) : limit_;
    }

    [[nodiscard]] std::vector<BrepVertexId> verticesToWeld() const
    {
        IdVector<BrepVertexId, std::uint8_t> isEnd(model_.vertices.size());
        for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
            if (!mayWeld(BrepEdgeId(e))) continue;
            isEnd[model_.edges[BrepEdgeId(e)].first] = 1;
            isEnd[model_.edges[BrepEdgeId(e)].last] = 1;
        }
        std::vector<BrepVertexId> vertices;
        for (std::uint32_t v = 0; v < model_.vertices.size(); ++v) {
            if (!scope_ || isEnd[BrepVertexId(v)] != 0) vertices.emplace_back(v);
        }
        return vertices;
    }

    void findVertices()
    {
        IndexedMap<std::pair<BrepVertexId, BrepVertexId>, bool> joined;
        for (const BrepEdge& edge : model_.edges) joined.insert(unorderedPair(edge.first, edge.last), true);
        std::vector<BrepVertexId> order = verticesToWeld();
        const double widest = scope_ ? std::max(limit_, scope_->most) : limit_;
        const auto xOf = [&](BrepVertexId v) { return model_.vertices[v].position.x; };
        std::sort(order.begin(), order.end(), [&](BrepVertexId a, BrepVertexId b) {
            return std::pair(xOf(a), a) < std::pair(xOf(b), b);
        });
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (std::size_t k = i + 1; k < order.size() && xOf(order[k]) - xOf(order[i]) <= widest; ++k) {
                const auto [low, high] = unorderedPair(order[i], order[k]);
                const Vec3 apart = model_.vertices[high].position - model_.vertices[low].position;
                const double limit =
                    limitFor(model_.vertices[low].tolerance, model_.vertices[high].tolerance);
                if (length(apart) > limit || joined.contains(std::pair(low, high))) continue;
                weldVertices(welded_.vertex[low], welded_.vertex[high]);
            }
        }
    }

    void weldVertices(BrepVertexId a, BrepVertexId b)
    {
        if (a == b) return;
        const auto [kept, other] = unorderedPair(a, b);
        ++welded_.vertices;
        if (scope_) {
            BrepVertex& stays = model_.vertices[kept];
            const BrepVertex& goes = model_.vertices[other];
            stays.tolerance =
                std::max(stays.tolerance, length(stays.position - goes.position) + goes.tolerance);
        }
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
            if (edge.isDegenerate || !mayWeld(BrepEdgeId(e))) continue;
            std::vector<BrepEdgeId>& others = between[unorderedPair(edge.first, edge.last)];
            const auto same = std::find_if(others.begin(), others.end(), [&](BrepEdgeId other) {
                return areTwins(other, BrepEdgeId(e)) && !separateOneFace(other, BrepEdgeId(e));
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

    /// Do both bound one face, and are they more than the two uses of a seam that may be sewn?
    [[nodiscard]] bool separateOneFace(BrepEdgeId a, BrepEdgeId b) const
    {
        return std::any_of(model_.faces.begin(), model_.faces.end(), [&](const BrepFace& face) {
            const BrepCoedge *useOfA = nullptr, *useOfB = nullptr;
            for (const BrepLoop& loop : face.loops) {
                for (const BrepCoedge& coedge : loop.coedges) {
                    if (coedge.edge == a) useOfA = &coedge;
                    if (coedge.edge == b) useOfB = &coedge;
                }
            }
            return useOfA != nullptr && useOfB != nullptr && !(scope_ && areSeam(face, *useOfA, *useOfB));
        });
    }

    /// Edges at one place on opposite borders of the parameters.
    [[nodiscard]] bool areSeam(const BrepFace& face, const BrepCoedge& a, const BrepCoedge& b) const
    {
        constexpr double kLeastShare = 0.5;
        const auto middle = [&](const BrepCoedge& use) {
            return use.parameterCurve->position(model_.edges[use.edge].part.at(0.5));
        };
        const Vec2 apart = middle(a) - middle(b);
        return std::abs(apart.x) > kLeastShare * face.boundsU.length() ||
               std::abs(apart.y) > kLeastShare * face.boundsV.length();
    }

    /// Places along `other` that lie on `kept`.
    [[nodiscard]] bool areTwins(BrepEdgeId kept, BrepEdgeId other) const
    {
        constexpr std::array<double, 5> kShares{0.5, 0.25, 0.75, 0.1, 0.9};
        const BrepEdge &a = model_.edges[kept], &b = model_.edges[other];
        const double limit = limitFor(a.tolerance, b.tolerance);
        return std::all_of(kShares.begin(), kShares.end(), [&](double share) {
            const Vec3 onB = b.curve->position(b.part.at(share));
            const Vec3 onA = a.curve->position(a.part.at(share));
            return a.curve->project(onB, a.part).distance <= limit &&
                   b.curve->project(onA, b.part).distance <= limit;
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
                for (BrepCoedge& coedge : loop.coedges) replace(coedge, face);
            }
            for (BrepEdgeId& edge : face.embeddedEdges) edge = welded_.edge[edge];
        }
    }

    void replace(BrepCoedge& coedge, const BrepFace& face)
    {
        const BrepEdgeId kept = welded_.edge[coedge.edge];
        if (kept == coedge.edge) return;
        const bool turns = isOpposite_[coedge.edge] != 0;
        coedge.parameterCurve = std::make_shared<CurveOfTwin>(
            coedge.parameterCurve, model_.edges[coedge.edge], model_.edges[kept], turns);
        coedge.isReversed = coedge.isReversed != turns;
        coedge.edge = kept;
        if (scope_) widen(coedge, face);
    }

    /// The edge that stays may lie off the face of one that it stands for.
    void widen(BrepCoedge& coedge, const BrepFace& face)
    {
        constexpr int kSamples = 16;
        BrepEdge& edge = model_.edges[coedge.edge];
        for (int i = 0; i <= kSamples; ++i) {
            const double t = edge.part.at(static_cast<double>(i) / kSamples);
            const Vec3 lifted = face.surface->position(coedge.parameterCurve->position(t));
            coedge.gap = std::max(coedge.gap, length(lifted - edge.curve->position(t)));
        }
        edge.tolerance = std::max(edge.tolerance, coedge.gap);
    }

    BrepModel& model_;
    std::optional<WeldingScope> scope_;
    double limit_ = 0.0;
    IdVector<BrepEdgeId, std::uint8_t> isOpposite_;  ///< to the edge that stands for it
    WeldedEntities welded_;
};

}  // namespace

WeldedEntities weldCoincidences(BrepModel& model) { return Welder(model).run(); }

WeldedEntities weldEdges(BrepModel& model, WeldingScope scope)
{
    return Welder(model, std::move(scope)).run();
}

}  // namespace mesher
