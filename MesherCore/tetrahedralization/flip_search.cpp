#include "tetrahedralization/flip_search.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

int edgeOf(const Triangulation3d& mesh, TetId tet, VertexId a, VertexId b)
{
    return kEdgeOfSlots[mesh.slotOf(tet, a)][mesh.slotOf(tet, b)];
}

}  // namespace

double flatness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const Vec3 w = d - a;
    const double longest = std::max({squaredLength(u), squaredLength(v), squaredLength(w),
                                     squaredLength(c - b), squaredLength(d - b), squaredLength(d - c)});
    return dot(cross(u, v), w) / (longest * std::sqrt(longest));
}

void FlipSearch::apply(const Flip3d& flip)
{
    Step step;
    for (const TetId tet : flip.before) step.before.push_back(mesh_.tet(tet).vertex);
    applyFlip(replacement_, flip);
    step.created = replacement_.created();
    log_.push_back(std::move(step));
    ++flips_;
}

void FlipSearch::replace(std::span<const TetId> before, std::span<const TetCorners> after,
                         std::span<const VertexId> added)
{
    Step step;
    for (const TetId tet : before) step.before.push_back(mesh_.tet(tet).vertex);
    step.added.assign(added.begin(), added.end());
    replacement_.replace(before, after);
    step.created = replacement_.created();
    log_.push_back(std::move(step));
    ++flips_;
}

void FlipSearch::takeBackTo(std::size_t mark)
{
    while (log_.size() > mark) {
        replacement_.replace(log_.back().created, log_.back().before);
        for (const VertexId vertex : log_.back().added) mesh_.removeVertex(vertex);
        log_.pop_back();
        --flips_;
    }
}

bool FlipSearch::flipFace(TetFace face)
{
    const auto flip = evaluateFlip23(mesh_, face);
    if (!flip) return false;
    apply(*flip);
    return true;
}

/// Flips a face of the ring away, so that the ring has one tetrahedron less.
bool FlipSearch::shrinkRing(VertexId a, VertexId b)
{
    std::vector<TetId> ring;
    mesh_.collectEdgeRing(mesh_.findEdge(a, b), a, b, ring);
    for (const TetId tet : ring) {
        for (int face = 0; face < 4; ++face) {
            const VertexId opposite = mesh_.vertex(tet, face);
            if (opposite == a || opposite == b || !flipFace({tet, face})) continue;
            return true;
        }
    }
    return false;
}

/// Looks at the likely tetrahedra first: stars may be large.
TetId FlipSearch::findEdge(VertexId a, VertexId b, std::span<const TetId> likely) const
{
    const auto found = std::find_if(likely.begin(), likely.end(), [&](TetId tet) {
        return mesh_.isAlive(tet) && mesh_.slotOf(tet, a) >= 0 && mesh_.slotOf(tet, b) >= 0;
    });
    return found != likely.end() ? *found : mesh_.findEdge(a, b);
}

bool FlipSearch::removeRing(VertexId a, VertexId b, std::span<const TetId> likely, const TetMeasure& measure)
{
    const TetId tet = findEdge(a, b, likely);
    if (!tet.isValid()) return true;
    const auto flip = evaluateEdgeRemoval(mesh_, tet, edgeOf(mesh_, tet, a, b), measure);
    if (!flip) return false;
    apply(*flip);
    return true;
}

bool FlipSearch::removeEdge(VertexId a, VertexId b, TetId at, int depth, const TetMeasure& measure)
{
    const TetId tet = at.isValid() ? at : mesh_.findEdge(a, b);
    if (!tet.isValid()) return true;
    if (trials_ == 0 || mesh_.isEdgeConstrained(tet, edgeOf(mesh_, tet, a, b))) return false;
    --trials_;
    std::vector<TetId> ring;
    mesh_.collectEdgeRing(tet, a, b, ring);
    for (const TetId other : ring) {
        if (mesh_.isGhostTet(other)) return false;
        for (int face = 0; face < 4; ++face) {
            const VertexId opposite = mesh_.vertex(other, face);
            if (opposite != a && opposite != b && mesh_.isFaceConstrained({other, face})) return false;
        }
    }
    const std::size_t start = mark();
    for (std::size_t size = ring.size(); size > kMaxEdgeRing; --size) {
        if (!shrinkRing(a, b)) break;
    }
    if (removeRing(a, b, ring, measure)) return true;
    if (depth > 0) {
        std::vector<VertexId> link;
        for (const TetId other : ring) {
            for (const VertexId v : mesh_.isAlive(other) ? mesh_.tet(other).vertex : TetCorners{a, a, a, a}) {
                if (v != a && v != b && std::find(link.begin(), link.end(), v) == link.end())
                    link.push_back(v);
            }
        }
        for (const VertexId side : link) {
            for (const VertexId end : {a, b}) {
                const std::size_t before = mark();
                const TetId beside = findEdge(end, side, ring);
                if (!beside.isValid() || !removeEdge(end, side, beside, depth - 1, measure) ||
                    mark() == before)
                    continue;
                if (removeRing(a, b, ring, measure)) return true;
            }
        }
    }
    takeBackTo(start);
    return false;
}

}  // namespace mesher
