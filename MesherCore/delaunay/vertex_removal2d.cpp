#include "delaunay/vertex_removal2d.h"

#include "delaunay/flips2d.h"
#include "predicates/orient2d.h"

#include <algorithm>

namespace mesher {
namespace {

using Corner = RemovalWorkspace2d::Corner;

/// The corners of the hole; a ghost, if there is one, comes last.
void collectRing(const Triangulation2d& mesh, VertexId vertex, RemovalWorkspace2d& workspace)
{
    workspace.ring.clear();
    workspace.slots.clear();
    mesh.forEachTriangleAround(vertex, [&](EdgeLink opposite) {
        const RegionId region = mesh.triangle(opposite.triangle()).region;
        workspace.ring.push_back({mesh.edgeFrom(opposite), mesh.across(opposite), region, 0, 0, false});
        workspace.slots.push_back(opposite.triangle());
        return true;
    });
    const auto isGhost = [](const Corner& corner) { return corner.vertex == kGhostVertex; };
    const auto ghost = std::find_if(workspace.ring.begin(), workspace.ring.end(), isGhost);
    if (ghost != workspace.ring.end()) std::rotate(workspace.ring.begin(), ghost + 1, workspace.ring.end());
    const auto count = static_cast<std::uint32_t>(workspace.ring.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        workspace.ring[i].next = i + 1 == count ? 0 : i + 1;
        workspace.ring[i].previous = i == 0 ? count - 1 : i - 1;
    }
}

/// Fills the hole that a vertex leaves.
class HoleFilling
{
public:
    HoleFilling(Triangulation2d& mesh, const StaticFilter2d& filter, VertexId centre, const ChainEnds* chain,
                RemovalWorkspace2d& workspace)
        : mesh_(mesh),
          filter_(filter),
          centre_(mesh.position(centre)),
          chain_(chain),
          workspace_(workspace),
          ring_(workspace.ring),
          remaining_(static_cast<std::uint32_t>(workspace.ring.size()))
    {
    }

    void run()
    {
        workspace_.suspects.clear();
        const bool isOnHull = ring_.back().vertex == kGhostVertex;
        cutEars(isOnHull || chain_ != nullptr ? 2 : 3);
        if (isOnHull) {
            closeHull();
        } else if (chain_ != nullptr) {
            joinChain();
        } else {
            closeTriangle();
        }
        for (const TriangleId spare : workspace_.slots) mesh_.freeTriangle(spare);
    }

private:
    void cutEars(std::uint32_t smallest)
    {
        std::vector<std::uint32_t>& candidates = workspace_.candidates;
        candidates.clear();
        for (std::uint32_t i = 0; i < ring_.size(); ++i) candidates.push_back(i);
        // First in, first out: the ears of a round do not overlap, so the triangles stay compact.
        for (std::size_t i = 0; i < candidates.size() && remaining_ > smallest; ++i) {
            const std::uint32_t tip = candidates[i];
            if (ring_[tip].isCut || !isEar(tip)) continue;
            cut(tip);
            candidates.push_back(ring_[tip].previous);
            candidates.push_back(ring_[tip].next);
        }
    }

    [[nodiscard]] bool isEar(std::uint32_t tip) const
    {
        const VertexId a = ring_[ring_[tip].previous].vertex;
        const VertexId b = ring_[tip].vertex;
        const VertexId c = ring_[ring_[tip].next].vertex;
        if (a == kGhostVertex || b == kGhostVertex || c == kGhostVertex) return false;
        if (chain_ != nullptr && (b == chain_->from || b == chain_->to)) return false;
        const Vec2 from = mesh_.position(a);
        const Vec2 to = mesh_.position(c);
        return orient2d(filter_, from, mesh_.position(b), to) == Sign::Positive &&
               orient2d(filter_, from, to, centre_) != Sign::Negative;
    }

    void cut(std::uint32_t tip)
    {
        const Corner& corner = ring_[tip];
        Corner& before = ring_[corner.previous];
        const TriangleId t = make(before.vertex, corner.vertex, ring_[corner.next].vertex, corner.region);
        join(EdgeLink(t, 0), corner.outer);
        join(EdgeLink(t, 2), before.outer);
        before.outer = EdgeLink(t, 1);
        before.region = corner.region;
        workspace_.suspects.emplace_back(t, 1u);
        before.next = corner.next;
        ring_[corner.next].previous = corner.previous;
        ring_[tip].isCut = true;
        --remaining_;
    }

    void closeTriangle()
    {
        MESHER_INVARIANT(remaining_ == 3);
        const Corner& a = firstLeft();
        const Corner& b = ring_[a.next];
        const Corner& c = ring_[b.next];
        const TriangleId t = make(a.vertex, b.vertex, c.vertex, a.region);
        join(EdgeLink(t, 0), b.outer);
        join(EdgeLink(t, 1), c.outer);
        join(EdgeLink(t, 2), a.outer);
    }

    /// Either side of the chain has been filled up to the edge between its ends.
    void joinChain()
    {
        MESHER_INVARIANT(remaining_ == 2);
        const Corner& a = firstLeft();
        const Corner& b = ring_[a.next];
        mesh_.link(a.outer, b.outer);
        mesh_.setConstrained(a.outer, true);
        mesh_.setTriangleAt(a.vertex, a.outer.triangle());
        mesh_.setTriangleAt(b.vertex, b.outer.triangle());
    }

    /// A ghost for each edge of the chain that is left between the former neighbours on the hull.
    void closeHull()
    {
        const Corner& ghost = ring_.back();
        EdgeLink previous = ghost.outer;
        for (std::uint32_t i = ghost.next; ring_[i].next != ring_.size() - 1; i = ring_[i].next) {
            const TriangleId t =
                make(ring_[i].vertex, ring_[ring_[i].next].vertex, kGhostVertex, RegionId(0));
            mesh_.link(EdgeLink(t, 1), previous);
            join(EdgeLink(t, 2), ring_[i].outer);
            if (chain_ != nullptr) mesh_.setConstrained(EdgeLink(t, 2), true);
            previous = EdgeLink(t, 0);
        }
        mesh_.link(previous, ring_[ghost.previous].outer);
    }

    [[nodiscard]] const Corner& firstLeft() const
    {
        return *std::find_if(ring_.begin(), ring_.end(), [](const Corner& corner) { return !corner.isCut; });
    }

    TriangleId make(VertexId a, VertexId b, VertexId c, RegionId region)
    {
        const TriangleId t = workspace_.slots.back();
        workspace_.slots.pop_back();
        Triangle2d& record = mesh_.triangle(t);
        record.v[0] = a;
        record.v[1] = b;
        record.v[2] = c;
        record.flags = 0;
        record.region = region;
        ++record.generation;
        for (const VertexId v : record.v) {
            if (v != kGhostVertex) mesh_.setTriangleAt(v, t);
        }
        return t;
    }

    void join(EdgeLink side, EdgeLink outer)
    {
        mesh_.link(side, outer);
        if (mesh_.isConstrained(outer)) mesh_.setConstrained(side, true);
    }

    Triangulation2d& mesh_;
    const StaticFilter2d& filter_;
    Vec2 centre_;
    const ChainEnds* chain_;
    RemovalWorkspace2d& workspace_;
    std::vector<Corner>& ring_;
    std::uint32_t remaining_;
};

}  // namespace

bool isLastOffLine(const Triangulation2d& mesh, const StaticFilter2d& filter, VertexId vertex,
                   RemovalWorkspace2d& workspace)
{
    collectRing(mesh, vertex, workspace);
    const std::vector<Corner>& ring = workspace.ring;
    if (ring.back().vertex != kGhostVertex) return false;
    // Without the vertex' own triangles only ghosts may be left: one more than the edges it is joined to.
    const std::size_t finiteInStar = ring.size() - 2;
    if (mesh.triangleCount() != finiteInStar + (finiteInStar + 2)) return false;
    const Vec2 a = mesh.position(ring[0].vertex);
    const Vec2 b = mesh.position(ring[1].vertex);
    return std::all_of(ring.begin() + 2, ring.end() - 1, [&](const Corner& corner) {
        return orient2d(filter, a, b, mesh.position(corner.vertex)) == Sign::Zero;
    });
}

std::size_t removeVertex(Triangulation2d& mesh, const StaticFilter2d& filter, VertexId vertex,
                         const ChainEnds* chain, RemovalWorkspace2d& workspace)
{
    collectRing(mesh, vertex, workspace);
    HoleFilling(mesh, filter, vertex, chain, workspace).run();
    mesh.removeVertex(vertex);
    return restoreDelaunay(mesh, filter, workspace.suspects);
}

}  // namespace mesher
