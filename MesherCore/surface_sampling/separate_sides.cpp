#include "base/indexed_map.h"
#include "surface_sampling/face_points.h"
#include "surface_sampling/face_refinement.h"

#include <algorithm>
#include <vector>

namespace mesher {

namespace {

/// What a vertex is in space: its node, or a point of its own inside of the face.
using SpaceKey = std::uint64_t;

class SideSeparator
{
public:
    SideSeparator(const BrepFace& face, const FaceOutline& outline,
                  std::span<const std::pair<NodeId, NodeId>> taken, FaceTriangulation& t)
        : face_(face), outline_(outline), t_(t)
    {
        for (const auto& [a, b] : taken) taken_.insert(unorderedPair(keyOf(a), keyOf(b)), true);
    }

    bool splitOnce()
    {
        collect();
        bool isChanged = false;
        for (const auto& [a, b] : doomed_) {
            const EdgeLink side = t_.mesh().findEdge(a, b);
            if (!side.isValid()) continue;
            if (turnAtPole(side)) {
                isChanged = true;
                continue;
            }
            const Vec2 uv = middleOf(t_.points[a], t_.points[b]);
            isChanged = insertFacePoint(face_, uv, side.triangle(), t_).has_value() || isChanged;
        }
        return isChanged;
    }

private:
    static SpaceKey keyOf(NodeId node) { return node.value; }
    [[nodiscard]] SpaceKey keyOf(VertexId v) const
    {
        const NodeId node = t_.points[v].node;
        return node.isValid() ? keyOf(node) : SpaceKey{1} << 32 | v.value;
    }

    [[nodiscard]] bool vanishes(TriangleId t) const
    {
        const Triangle2d& triangle = t_.mesh().triangle(t);
        for (unsigned i = 0; i < 3; ++i) {
            const FacePoint &a = t_.points[triangle.v[i]], &b = t_.points[triangle.v[nextCorner(i)]];
            if (a.isPole && b.isPole && a.node == b.node) return true;
        }
        return false;
    }

    /// A curve that ends in a pole is a side there itself, not another image of the pole joined to its node: the other diagonal is
    /// held. A point in the middle would lie beside the curve's last segment, nearer to the pole than any other.
    bool turnAtPole(EdgeLink side)
    {
        const FacePoint &from = t_.points[t_.mesh().edgeFrom(side)], &to = t_.points[t_.mesh().edgeTo(side)];
        if (from.isPole == to.isPole) return false;
        const VertexId near = t_.mesh().apex(side), far = t_.mesh().apex(t_.mesh().across(side));
        if (isGhost(near) || isGhost(far)) return false;
        const NodeId pole = from.isPole ? from.node : to.node;
        const auto isImage = [&](VertexId v) { return t_.points[v].isPole && t_.points[v].node == pole; };
        if (isImage(near) == isImage(far)) return false;
        return t_.delaunay.recoverSegment(near, far).hasValue() && t_.delaunay.lastSegment().size() == 2;
    }

    template <class Visit>
    void forEachSide(Visit&& visit) const
    {
        for (std::uint32_t i = 0; i < t_.mesh().triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!t_.mesh().isAlive(t) || !t_.isInside(t) || vanishes(t)) continue;
            for (unsigned k = 0; k < 3; ++k) visit(EdgeLink(t, k));
        }
    }

    /// The free sides that are one with another in space, by their ends in the plane.
    void collect()
    {
        IndexedMap<std::pair<SpaceKey, SpaceKey>, int> uses;
        IndexedMap<std::pair<SpaceKey, SpaceKey>, bool> pieces;
        for (const OutlinePiece& piece : outline_.pieces) {
            const auto key = [&](std::uint32_t point) { return keyOf(outline_.points[point].node); };
            if (piece.segment.isValid()) pieces.insert(unorderedPair(key(piece.from), key(piece.to)), true);
        }
        forEachSide([&](EdgeLink side) {
            ++uses[{keyOf(t_.mesh().edgeFrom(side)), keyOf(t_.mesh().edgeTo(side))}];
        });
        doomed_.clear();
        forEachSide([&](EdgeLink side) {
            if (t_.mesh().isConstrained(side)) return;
            const VertexId from = t_.mesh().edgeFrom(side), to = t_.mesh().edgeTo(side);
            const SpaceKey a = keyOf(from), b = keyOf(to);
            const auto key = unorderedPair(a, b);
            if (a == b || *uses.find({a, b}) > 1 || pieces.contains(key) || taken_.contains(key))
                doomed_.push_back(unorderedPair(from, to));
        });
        std::sort(doomed_.begin(), doomed_.end());
        doomed_.erase(std::unique(doomed_.begin(), doomed_.end()), doomed_.end());
    }

    const BrepFace& face_;
    const FaceOutline& outline_;
    FaceTriangulation& t_;
    IndexedMap<std::pair<SpaceKey, SpaceKey>, bool> taken_;
    std::vector<std::pair<VertexId, VertexId>> doomed_;
};

}  // namespace

bool separateSides(const BrepFace& face, const FaceOutline& outline,
                   std::span<const std::pair<NodeId, NodeId>> taken, FaceTriangulation& t)
{
    return SideSeparator(face, outline, taken, t).splitOnce();
}

}  // namespace mesher
