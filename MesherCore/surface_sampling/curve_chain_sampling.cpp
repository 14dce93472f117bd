#include "base/indexed_map.h"
#include "surface_sampling/curve_chains.h"
#include "surface_sampling/curve_division.h"
#include "surface_sampling/small_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mesher {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
// Chords of curves that should be straight, radians.
constexpr double kStraight = 1e-9;

}  // namespace

/// Fills new chains: nodes of the vertices, then edge by edge.
class CurveChainSampler
{
public:
    CurveChainSampler(const BrepModel& model, const CurveChainOptions& options,
                      IdVector<NodeId, MeshNode>& nodes, RunContext& context)
        : model_(model), options_(options), nodes_(nodes), watch_(context, kStepsPerAsk)
    {
    }

    Result<CurveChains> run()
    {
        MESHER_PRECONDITION(nodes_.empty());
        chains_.model_ = &model_;
        for (std::uint32_t v = 0; v < model_.vertices.size(); ++v) {
            nodes_.push_back({model_.vertices[BrepVertexId(v)].position, {0, v}, {}});
        }
        measureFloors();
        for (std::uint32_t e = 0; e < model_.edges.size() && watch_.mayGoOn(); ++e) {
            if (auto sampled = sampleEdge(BrepEdgeId(e)); !sampled) return sampled.error();
        }
        if (watch_.stopReason()) return std::move(chains_);
        if (auto separated = separateTwins(); !separated) return separated.error();
        protectSmallAngles(chains_, nodes_, options_);
        return std::move(chains_);
    }

private:
    /// From the gaps there are; tolerances that CAD programs write are at times larger than the edge.
    void measureFloors()
    {
        constexpr double kLeastGap = 1e-7;
        IdVector<BrepEdgeId, double> gaps(model_.edges.size(), 0.0);
        for (const BrepFace& face : model_.faces) {
            for (const BrepLoop& loop : face.loops) {
                for (const BrepCoedge& coedge : loop.coedges)
                    gaps[coedge.edge] = std::max(gaps[coedge.edge], coedge.gap);
            }
        }
        chains_.vertexFloors_.resize(model_.vertices.size(), 0.0);
        for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
            const BrepEdge& edge = model_.edges[BrepEdgeId(e)];
            const double gap = std::min(edge.tolerance, std::max(gaps[BrepEdgeId(e)], kLeastGap));
            chains_.floors_.push_back(options_.floorInTolerances * gap);
            if (edge.isDegenerate) continue;
            includeEnd(edge, edge.part.first, edge.first);
            includeEnd(edge, edge.part.last, edge.last);
        }
    }

    void includeEnd(const BrepEdge& edge, double t, BrepVertexId id)
    {
        const BrepVertex& vertex = model_.vertices[id];
        const double gap = std::min(vertex.tolerance, length(edge.curve->position(t) - vertex.position));
        double& least = chains_.vertexFloors_[id];
        least = std::max(least, options_.floorInTolerances * gap);
    }

    Result<void> sampleEdge(BrepEdgeId id)
    {
        const BrepEdge& edge = model_.edges[id];
        chains_.firstOf_.push_back(SegmentId());
        if (edge.isDegenerate) {
            chains_.variations_.push_back(std::nullopt);
            return {};
        }
        chains_.variations_.push_back(std::optional<TangentVariation>(std::in_place, edge.curve, edge.part));
        const std::vector<double> parameters = divideCurve(*chains_.variations_[id], wishesOf(id), watch_);
        if (parameters.empty()) return tooMany(id);
        if (chains_.segments_.size() + parameters.size() > options_.maxSegments) return tooMany(id);
        addChain(id, parameters);
        return {};
    }

    /// A closed edge needs three segments.
    [[nodiscard]] CurveWishes wishesOf(BrepEdgeId id) const
    {
        CurveWishes wishes;
        wishes.maxVariation = options_.maxVariation * kRadiansPerDegree;
        if (options_.segmentsPerTurn > 0.0)
            wishes.maxVariation =
                std::min(wishes.maxVariation, 2.0 * std::numbers::pi / options_.segmentsPerTurn);
        wishes.maxSag = options_.maxSag;
        wishes.sizes = options_.sizes;
        wishes.floor = chains_.floors_[id];
        wishes.leastPieces = model_.edges[id].isClosed() ? 3 : 1;
        wishes.mostPieces = static_cast<double>(options_.maxSegments);
        return wishes;
    }

    void addChain(BrepEdgeId id, const std::vector<double>& parameters)
    {
        const BrepEdge& edge = model_.edges[id];
        NodeId previous(edge.first.value);
        SegmentId before;
        for (std::size_t i = 1; i < parameters.size() && watch_.mayGoOn(); ++i) {
            const double t = parameters[i];
            const NodeId next = i + 1 == parameters.size()
                                    ? NodeId(edge.last.value)
                                    : nodes_.push_back({edge.curve->position(t), {1, id.value}, {t, 0.0}});
            const SegmentId s = chains_.segments_.push_back({{previous, next}, id, {parameters[i - 1], t}});
            CurveChains::Record record;
            record.previous = before;
            chains_.records_.push_back(record);
            if (before.isValid()) {
                chains_.records_[before].next = s;
            } else {
                chains_.firstOf_[id] = s;
            }
            before = s;
            previous = next;
            ++chains_.aliveCount_;
        }
    }

    /// Two segments between the same nodes would be one edge of the mesh: the one that turns more is split.
    Result<void> separateTwins()
    {
        IndexedMap<std::pair<NodeId, NodeId>, SegmentId> sides;
        const std::size_t count = chains_.segments_.size();
        for (std::uint32_t i = 0; i < count; ++i) {
            const SegmentId s(i);
            const auto key = unorderedPair(chains_.segments_[s].node[0], chains_.segments_[s].node[1]);
            const auto [twin, isNew] = sides.insert(key, s);
            if (isNew) continue;
            const SegmentId other = *twin;
            const bool splitsOther = turningOf(other) > turningOf(s);
            const SegmentId bent = splitsOther ? other : s;
            if (!(turningOf(bent) > kStraight) || !chains_.split(bent, nodes_)) return twinError(s, other);
            if (splitsOther) *twin = s;
        }
        return {};
    }

    [[nodiscard]] double turningOf(SegmentId s) const
    {
        const SurfaceSegment& segment = chains_.segments_[s];
        return chains_.variations_[segment.edge]->variation(segment.parameter[0], segment.parameter[1]);
    }

    [[nodiscard]] Error twinError(SegmentId a, SegmentId b) const
    {
        Error error;
        error.code = ErrorCode::IntersectingConstraints;
        error.entity = nameOf(chains_.segments_[a].edge) + " and " + nameOf(chains_.segments_[b].edge);
        error.message = "two edges coincide";
        error.point = nodes_[chains_.segments_[a].node[0]].position;
        error.remedy = "sew the faces beside them, or remove one of them";
        return error;
    }

    [[nodiscard]] Error tooMany(BrepEdgeId id) const
    {
        Error error;
        error.code = ErrorCode::OutOfRange;
        error.entity = nameOf(id);
        error.message = "the curves need more than " + std::to_string(options_.maxSegments) + " segments";
        error.point = model_.edges[id].curve->position(model_.edges[id].part.first);
        error.remedy = "ask for larger sizes or a larger sag";
        return error;
    }

    const BrepModel& model_;
    const CurveChainOptions& options_;
    static constexpr std::uint32_t kStepsPerAsk = 16;

    IdVector<NodeId, MeshNode>& nodes_;
    StepWatch watch_;
    CurveChains chains_;
};

Result<CurveChains> sampleCurveChains(const BrepModel& model, const CurveChainOptions& options,
                                      IdVector<NodeId, MeshNode>& nodes, RunContext& context)
{
    return CurveChainSampler(model, options, nodes, context).run();
}

}  // namespace mesher
