#include "surface_sampling/face_outline.h"

#include "base/box.h"
#include "base/indexed_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace mesher {

namespace {

// Poles are cut into pieces of no more than this share of the outline's size.
constexpr double kPolePiece = 0.125;
// Ends of parameter curves that are one but for rounding, relative to the outline's size.
constexpr double kRoundingShare = 1e-9;

/// A coedge's chain in the parameters, in the direction of the loop.
struct Strand
{
    std::uint32_t coedge = 0;
    std::vector<NodeId> nodes;
    std::vector<SegmentId> segments;  ///< one less than nodes; none along a pole
    std::vector<Vec2> uv;
    std::vector<Vec2> middles;  ///< of the parameter curve, by segment
    Vec2 shift;
    bool isPole = false;
};

class OutlineBuilder
{
public:
    OutlineBuilder(const BrepModel& model, BrepFaceId id, const CurveChains& chains,
                   const IdVector<NodeId, MeshNode>& nodes)
        : model_(model), id_(id), face_(model.faces[id]), chains_(chains), nodes_(nodes)
    {
        outline_.scaling = FaceScaling(face_);
        period_ = {face_.surface->periodU(), face_.surface->periodV()};
    }

    Result<FaceOutline> run()
    {
        std::vector<std::vector<Strand>> loops;
        for (const BrepLoop& loop : face_.loops) loops.push_back(strandsOf(loop));
        measure(loops);
        for (std::uint32_t i = 0; i < loops.size(); ++i) {
            if (auto sound = checkPoles(i, loops[i]); !sound) return sound.error();
            if (auto added = addLoop(i, loops[i]); !added) return added.error();
        }
        for (const BrepEdgeId edge : face_.embeddedEdges) addEmbedded(edge);
        for (const BrepVertexId vertex : face_.embeddedVertices) {
            const NodeId node(vertex.value);
            addPoint(node, parametersOf(nodes_[node].position), closenessAt(node));
        }
        return std::move(outline_);
    }

private:
    std::vector<Strand> strandsOf(const BrepLoop& loop) const
    {
        std::vector<Strand> strands;
        for (std::uint32_t i = 0; i < loop.coedges.size(); ++i) {
            Strand strand = chains_.firstOf(loop.coedges[i].edge).isValid() ? strandAlong(loop.coedges[i])
                                                                            : poleAlong(loop.coedges[i]);
            strand.coedge = i;
            strands.push_back(std::move(strand));
        }
        return strands;
    }

    Strand strandAlong(const BrepCoedge& coedge) const
    {
        Strand strand;
        const std::vector<SegmentId> chain = chains_.chainOf(coedge.edge);
        const auto add = [&](NodeId node, double t) {
            strand.nodes.push_back(node);
            strand.uv.push_back(parametersAt(coedge, node, t));
        };
        add(chains_.segments()[chain.front()].node[0], chains_.segments()[chain.front()].parameter[0]);
        for (const SegmentId s : chain) {
            const SurfaceSegment& segment = chains_.segments()[s];
            strand.segments.push_back(s);
            strand.middles.push_back(
                coedge.parameterCurve->position(0.5 * (segment.parameter[0] + segment.parameter[1])));
            add(segment.node[1], segment.parameter[1]);
        }
        if (coedge.isReversed) {
            std::reverse(strand.nodes.begin(), strand.nodes.end());
            std::reverse(strand.uv.begin(), strand.uv.end());
            std::reverse(strand.segments.begin(), strand.segments.end());
            std::reverse(strand.middles.begin(), strand.middles.end());
        }
        return strand;
    }

    /// By the parameter curve, or the closest point of the surface where that runs beside the edge.
    [[nodiscard]] Vec2 parametersAt(const BrepCoedge& coedge, NodeId node, double t) const
    {
        constexpr double kExact = 1e-7;
        const Vec2 uv = coedge.parameterCurve->position(t);
        if (nodes_[node].entity.dimension != 1) return uv;
        const Vec3& position = nodes_[node].position;
        const double gap = length(face_.surface->position(uv) - position);
        if (!(gap > kExact)) return uv;
        const SurfaceProjection closest = face_.surface->project(position, uv);
        return closest.distance < 0.9 * gap ? closest.parameters : uv;
    }

    Strand poleAlong(const BrepCoedge& coedge) const
    {
        const BrepEdge& edge = model_.edges[coedge.edge];
        const double from = coedge.isReversed ? edge.part.last : edge.part.first;
        const double to = coedge.isReversed ? edge.part.first : edge.part.last;
        return poleBetween(NodeId(edge.first.value), coedge.parameterCurve->position(from),
                           coedge.parameterCurve->position(to));
    }

    static Strand poleBetween(NodeId node, Vec2 from, Vec2 to)
    {
        Strand strand;
        strand.isPole = true;
        strand.nodes = {node, node};
        strand.uv = {from, to};
        return strand;
    }

    void measure(const std::vector<std::vector<Strand>>& loops)
    {
        Box2 box;
        for (const auto& loop : loops) {
            for (const Strand& strand : loop) {
                for (const Vec2 uv : strand.uv) box.include(outline_.scaling.toPlane(uv));
            }
        }
        outline_.size = box.isEmpty() ? 0.0 : length(box.extent());
    }

    [[nodiscard]] double distance(Vec2 a, Vec2 b) const { return length(outline_.scaling.toPlane(a - b)); }

    /// How far the images of a node may lie apart for being one, in the plane.
    [[nodiscard]] double closenessAt(NodeId node) const
    {
        double closeness = face_.tolerance;
        const EntityRef entity = nodes_[node].entity;
        if (entity.dimension == 0)
            closeness = std::max(closeness, 2.0 * model_.vertices[BrepVertexId(entity.index)].tolerance);
        if (entity.dimension == 1)
            closeness = std::max(closeness, 2.0 * model_.edges[BrepEdgeId(entity.index)].tolerance);
        return std::max(closeness, kRoundingShare * outline_.size);
    }

    /// Files mark edges as poles that are none.
    [[nodiscard]] Result<void> checkPoles(std::uint32_t loop, const std::vector<Strand>& strands) const
    {
        constexpr double kReach = 0.05;
        for (const Strand& strand : strands) {
            const double gap = face_.loops[loop].coedges[strand.coedge].gap;
            if (strand.isPole && gap > kReach * outline_.size)
                return failure(strand, "an edge is marked as a pole and has an extent", "heal the shape");
        }
        return {};
    }

    static double shiftOf(double difference, double period)
    {
        return period > 0.0 ? period * std::round(difference / period) : 0.0;
    }

    Result<void> addLoop(std::uint32_t index, std::vector<Strand> strands)
    {
        if (strands.empty()) return {};
        std::vector<Strand> closed;
        for (std::size_t i = 0; i < strands.size(); ++i) {
            if (i > 0) {
                moveBehind(closed.back().uv.back(), strands[i]);
                if (auto joined = join(closed, strands[i].uv.front(), strands[i]); !joined) return joined;
            }
            closed.push_back(std::move(strands[i]));
        }
        // The loop ends where it began, without a shift: else it goes around the surface.
        const Vec2 difference = closed.front().uv.front() - closed.back().uv.back();
        const bool isWound =
            (shiftOf(difference.x, period_.x) != 0.0 || shiftOf(difference.y, period_.y) != 0.0) &&
            !isSingularBetween(closed.back().nodes.back(), closed.back().uv.back(),
                               closed.front().uv.front());
        if (isWound)
            return failure(closed.front(), "a loop goes around the surface without a seam",
                           "cut the face by its seam, as healing the shape does");
        if (auto joined = join(closed, closed.front().uv.front(), closed.front()); !joined) return joined;
        addPieces(index, closed);
        return {};
    }

    /// Into the image of the face that the loop has been in so far.
    void moveBehind(Vec2 end, Strand& strand) const
    {
        const Vec2 difference = end - strand.uv.front();
        const Vec2 shift{shiftOf(difference.x, period_.x), shiftOf(difference.y, period_.y)};
        // From one side of a pole to the other is no step into another image.
        if (shift == Vec2{} || isSingularBetween(strand.nodes.front(), end, strand.uv.front())) return;
        strand.shift = shift;
        for (Vec2& uv : strand.uv) uv = uv + strand.shift;
        for (Vec2& uv : strand.middles) uv = uv + strand.shift;
    }

    /// Makes the end of the last strand the start of the next one.
    Result<void> join(std::vector<Strand>& strands, Vec2 start, Strand& next) const
    {
        Strand& last = strands.back();
        const Vec2 end = last.uv.back();
        if (end == start) return {};
        const NodeId node = last.nodes.back();
        if (node != next.nodes.front())
            return failure(last, "a loop is open", "heal the shape, or close the wire");
        const double gap = distance(end, start);
        const double shortest = std::min(distance(last.uv.back(), last.uv[last.uv.size() - 2]),
                                         distance(next.uv.front(), next.uv[1]));
        if (gap > kRoundingShare * outline_.size && isSingularBetween(node, end, start) &&
            gap > 0.01 * shortest) {
            strands.push_back(poleBetween(node, end, start));
            return {};
        }
        if (gap > closenessAt(node) && gap > 0.5 * shortest) {
            return failure(last, "a loop is open in the parameters by " + std::to_string(gap),
                           "heal the shape, or make the edges meet on the face");
        }
        const Vec2 middle = 0.5 * (end + start);
        // A pole's end is where its neighbour says.
        last.uv.back() = next.isPole && !last.isPole ? end : (last.isPole && !next.isPole ? start : middle);
        next.uv.front() = last.uv.back();
        return {};
    }

    /// Is the line between the parameters one point of space?
    [[nodiscard]] bool isSingularBetween(NodeId node, Vec2 a, Vec2 b) const
    {
        constexpr int kSteps = 4;
        const double reach =
            2.0 * std::max(closenessAt(node), length(face_.surface->position(a) - nodes_[node].position));
        for (int i = 0; i <= kSteps; ++i) {
            const Vec2 uv = a + (static_cast<double>(i) / kSteps) * (b - a);
            if (!(length(face_.surface->position(uv) - nodes_[node].position) <= reach)) return false;
        }
        return reach < 0.01 * distance(a, b);
    }

    void addPieces(std::uint32_t loop, const std::vector<Strand>& strands)
    {
        for (const Strand& strand : strands) {
            if (strand.isPole) {
                addPole(loop, strand);
                continue;
            }
            const auto last = strand.segments.size();
            std::uint32_t from = addPoint(strand.nodes.front(), strand.uv.front(), closenessOf(strand, 0));
            for (std::size_t i = 0; i < last; ++i) {
                const std::uint32_t to =
                    addPoint(strand.nodes[i + 1], strand.uv[i + 1], closenessOf(strand, i));
                OutlinePiece piece = pieceBetween(from, to, loop, strand);
                piece.segment = strand.segments[i];
                piece.bulge = bulgeOf(strand, i);
                piece.sag = sagOf(strand.segments[i]);
                outline_.pieces.push_back(piece);
                from = to;
            }
        }
    }

    static OutlinePiece pieceBetween(std::uint32_t from, std::uint32_t to, std::uint32_t loop,
                                     const Strand& strand)
    {
        OutlinePiece piece;
        piece.from = from;
        piece.to = to;
        piece.loop = loop;
        piece.coedge = strand.coedge;
        piece.shift = strand.shift;
        return piece;
    }

    [[nodiscard]] Vec3 sagOf(SegmentId s) const
    {
        const SurfaceSegment& segment = chains_.segments()[s];
        const Curve& curve = *model_.edges[segment.edge].curve;
        if (curve.kind() == CurveKind::Line) return {};
        const Vec3 middle = 0.5 * (nodes_[segment.node[0]].position + nodes_[segment.node[1]].position);
        return curve.position(0.5 * (segment.parameter[0] + segment.parameter[1])) - middle;
    }

    [[nodiscard]] double bulgeOf(const Strand& strand, std::size_t i) const
    {
        const Vec2 chord = outline_.scaling.toPlane(strand.uv[i + 1] - strand.uv[i]);
        const Vec2 middle = outline_.scaling.toPlane(strand.middles[i] - strand.uv[i]);
        const double size = length(chord);
        return size > 0.0 ? cross(chord, middle) / size : 0.0;
    }

    /// Images of a node are one if they are closer than the tolerance and than a part of the piece that ends there.
    [[nodiscard]] double closenessOf(const Strand& strand, std::size_t i) const
    {
        constexpr double kShare = 0.1;
        const double piece = distance(strand.uv[i], strand.uv[i + 1]);
        return std::min(closenessAt(strand.nodes[i]), kShare * piece);
    }

    void addPole(std::uint32_t loop, const Strand& strand)
    {
        const Vec2 a = strand.uv.front(), b = strand.uv.back();
        const double extent = distance(a, b);
        if (!(extent > kRoundingShare * outline_.size)) return;
        const int pieces = std::max(1, static_cast<int>(std::ceil(extent / (kPolePiece * outline_.size))));
        const Vec2 direction = b - a;
        const bool isAlongU =
            std::abs(direction.x) * face_.boundsV.length() >= std::abs(direction.y) * face_.boundsU.length();
        std::uint32_t from = 0;
        for (double i = 0.0; i <= pieces; ++i) {
            const Vec2 uv = i == pieces ? b : a + (i / pieces) * direction;
            const std::uint32_t to = addPoint(strand.nodes.front(), uv, kRoundingShare * outline_.size);
            outline_.points[to].isPole = true;
            outline_.points[to].isPoleAlongU = isAlongU;
            if (i > 0) outline_.pieces.push_back(pieceBetween(from, to, loop, strand));
            from = to;
        }
    }

    std::uint32_t addPoint(NodeId node, Vec2 uv, double closeness)
    {
        std::vector<std::uint32_t>& images = imagesOf_[node];
        for (const std::uint32_t image : images) {
            if (distance(outline_.points[image].uv, uv) <= closeness) return image;
        }
        const auto index = static_cast<std::uint32_t>(outline_.points.size());
        images.push_back(index);
        outline_.points.push_back({node, uv, outline_.scaling.toPlane(uv), false, false});
        return index;
    }

    /// In the image of the face's bounds.
    [[nodiscard]] Vec2 parametersOf(const Vec3& position) const
    {
        Vec2 uv = face_.surface->project(position).parameters;
        const auto intoBounds = [](double value, Interval bounds, double period) {
            return period > 0.0 ? value + shiftOf(bounds.at(0.5) - value, period) : value;
        };
        uv.x = intoBounds(uv.x, face_.boundsU, period_.x);
        uv.y = intoBounds(uv.y, face_.boundsV, period_.y);
        return uv;
    }

    void addEmbedded(BrepEdgeId edge)
    {
        for (const SegmentId s : chains_.chainOf(edge)) {
            const auto [a, b] = chains_.segments()[s].node;
            OutlinePiece piece;
            piece.from = addPoint(a, parametersOf(nodes_[a].position), closenessAt(a));
            piece.to = addPoint(b, parametersOf(nodes_[b].position), closenessAt(b));
            piece.segment = s;
            piece.isEmbedded = true;
            outline_.pieces.push_back(piece);
        }
    }

    [[nodiscard]] Error failure(const Strand& strand, std::string message, std::string remedy) const
    {
        Error error;
        error.code = ErrorCode::DegenerateInput;
        error.entity = nameOf(id_);
        error.message = std::move(message);
        error.point = nodes_[strand.nodes.back()].position;
        error.remedy = std::move(remedy);
        return error;
    }

    const BrepModel& model_;
    BrepFaceId id_;
    const BrepFace& face_;
    const CurveChains& chains_;
    const IdVector<NodeId, MeshNode>& nodes_;
    Vec2 period_;
    FaceOutline outline_;
    IndexedMap<NodeId, std::vector<std::uint32_t>> imagesOf_;
};

}  // namespace

Result<FaceOutline> outlineOf(const BrepModel& model, BrepFaceId face, const CurveChains& chains,
                              const IdVector<NodeId, MeshNode>& nodes)
{
    return OutlineBuilder(model, face, chains, nodes).run();
}

}  // namespace mesher
