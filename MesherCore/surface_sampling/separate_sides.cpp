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

    template <class Visit>
    void forEachSide(Visit&& visit) const
    {
        for (std::uint32_t i = 0; i < t_.mesh().triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!t_.mesh().isAlive(t) || !t_.isInside(t) || vanishes(t)) continue;
            for (unsigned k = 0; k < 3; ++k) visit(EdgeLink(t, k));
        }
    }

    /// The free sides that are one with another in space, by their ends in the plane. Beside a pole a side may well be one with the
    /// segment that ends there: if nothing but triangles that vanish lies between the two, it is the segment.
    void collect()
    {
        IndexedMap<std::pair<SpaceKey, SpaceKey>, int> uses, pieces;
        for (const OutlinePiece& piece : outline_.pieces) {
            const auto key = [&](std::uint32_t point) { return keyOf(outline_.points[point].node); };
            if (piece.segment.isValid()) ++pieces[unorderedPair(key(piece.from), key(piece.to))];
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
            const int* piecesThere = pieces.find(key);
            const int* usesBehind = uses.find({b, a});
            const int allUses = *uses.find({a, b}) + (usesBehind == nullptr ? 0 : *usesBehind);
            if (a == b || *uses.find({a, b}) > 1 || taken_.contains(key) ||
                (piecesThere != nullptr && allUses > *piecesThere))
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
