#include "improvement/tet_improver.h"

#include "improvement/edge_contraction.h"
#include "improvement/face_removal.h"

#include <algorithm>
#include <array>

namespace mesher {

namespace {

/// The edges of a tetrahedron, that of the largest dihedral angle first: to do without it helps flat ones most.
std::array<std::size_t, 6> edgesByAngle(const TetCorners& p)
{
    const std::array<Vec3, 4> face = {cross(p[2] - p[1], p[3] - p[1]), cross(p[3] - p[0], p[2] - p[0]),
                                      cross(p[1] - p[0], p[3] - p[0]), cross(p[2] - p[0], p[1] - p[0])};
    std::array<double, 4> size{};
    for (std::size_t i = 0; i < 4; ++i) size[i] = length(face[i]);
    std::array<std::pair<double, std::size_t>, 6> order;
    for (std::size_t e = 0; e < 6; ++e) {
        const auto& [k, l] = kTetEdgeCorners[5 - e];
        order[e] = {-dot(face[k], face[l]) / (size[k] * size[l]), e};
    }
    std::sort(order.begin(), order.end());
    std::array<std::size_t, 6> edges{};
    for (std::size_t e = 0; e < 6; ++e) edges[e] = order[e].second;
    return edges;
}

}  // namespace

bool TetImprover::improve(TetId t, double wanted)
{
    return reconnect(t, wanted) || moveNodes(t, wanted) || contract(t) || insert(t, wanted);
}

void TetImprover::improveWithSurroundings(TetId t, double wanted, ScoreRange around)
{
    around_.clear();
    for (const NodeId n : complex_.nodes(t)) {
        for (const TetId other : complex_.star(n)) {
            const double score = complex_.score(other);
            if (other != t && score >= around.low && score < around.high) around_.emplace_back(score, other);
        }
    }
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    for (const auto& [score, other] : around_) {
        if (!complex_.isAlive(other) || complex_.score(other) >= around.high) continue;
        if (!reconnect(other, around.high)) moveNodes(other, around.high);
    }
    if (complex_.isAlive(t) && complex_.score(t) < wanted) improve(t, wanted);
}

/// Takes the best of the changes that do without an edge or a face of a tetrahedron, the first that reaches what is wanted.
bool TetImprover::reconnect(TetId t, double wanted)
{
    best_.clear();
    Kind kind = Kind::None;
    const TetNodes v = complex_.nodes(t);
    for (const std::size_t e : edgesByAngle(complex_.corners(v))) {
        if (best_.score >= wanted) break;
        const auto& [i, j] = kTetEdgeCorners[e];
        if (!evaluateEdgeRemoval(complex_, geometry_, v[i], v[j], {boundary_, best_.score}, change_))
            continue;
        kind = change_.swapsFacets ? Kind::Swap : Kind::Edge;
        std::swap(best_, change_);
    }
    for (std::size_t i = 0; i < 4 && best_.score < wanted; ++i) {
        if (!evaluateFaceRemoval(complex_, t, i, best_.score, change_)) continue;
        kind = Kind::Face;
        std::swap(best_, change_);
    }
    if (kind == Kind::None) return false;
    if (kind == Kind::Swap && !geometry_.isPlane(complex_.face(best_.facets[0]))) ++counts_.curvedChanges;
    apply(best_, complex_, geometry_);
    ++(kind == Kind::Edge   ? counts_.edgeRemovals
       : kind == Kind::Swap ? counts_.boundarySwaps
                            : counts_.faceRemovals);
    return true;
}

bool TetImprover::moveNodes(TetId t, double wanted)
{
    const TetNodes v = complex_.nodes(t);
    bool isMoved = false;
    for (const NodeId n : v) {
        if (complex_.score(t) >= wanted) break;
        if (!smoothing_.evaluate(n, wanted)) continue;
        const BoundaryMove& move = smoothing_.move();
        const auto dimension = complex_.node(n).entity.dimension;
        if (dimension < 3) {
            if (!geometry_.isFlatAt(n)) ++counts_.curvedChanges;
            geometry_.commit(move);
        }
        complex_.move(n, move.position, move.parameters);
        ++(dimension == 3 ? counts_.innerMoves : dimension == 2 ? counts_.faceMoves : counts_.edgeMoves);
        isMoved = true;
    }
    return isMoved;
}

bool TetImprover::contract(TetId t)
{
    const TetNodes v = complex_.nodes(t);
    for (const NodeId n : v) {
        if (!evaluateContraction(complex_, n, change_)) continue;
        apply(change_, complex_, geometry_);
        ++counts_.contractions;
        return true;
    }
    return false;
}

bool TetImprover::insert(TetId t, double wanted)
{
    if (!insertion_.evaluate(t, leastBetter(complex_.score(t)), wanted, change_)) return false;
    apply(change_, complex_, geometry_);
    ++counts_.insertions;
    return true;
}

}  // namespace mesher
