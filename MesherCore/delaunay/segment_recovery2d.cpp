#include "delaunay/segment_recovery2d.h"

#include "delaunay/flips2d.h"
#include "predicates/orient2d.h"

#include <string>

namespace mesher {
namespace {

/// Follows the segment from `a` to the first vertex on it; `crossed` receives the edges in between, each seen from
/// the side of `a` and running from the right of the segment to its left.
class SegmentTrace
{
public:
    SegmentTrace(const Triangulation2d& mesh, const StaticFilter2d& filter, VertexId a, VertexId b)
        : mesh_(mesh), filter_(filter), a_(a), b_(b), from_(mesh.position(a)), to_(mesh.position(b))
    {
    }

    /// The first vertex on the segment after a.
    VertexId run(std::vector<EdgeLink>& crossed) const
    {
        crossed.clear();
        const VertexId neighbour = leaveStart(crossed);
        if (neighbour.isValid()) return neighbour;
        for (;;) {
            const EdgeLink entry = mesh_.across(crossed.back());
            const VertexId apex = mesh_.apex(entry);
            if (apex == b_) return apex;
            const Sign side = orient2d(filter_, from_, to_, mesh_.position(apex));
            if (side == Sign::Zero) return apex;
            const unsigned exit =
                side == Sign::Positive ? nextCorner(entry.edge()) : previousCorner(entry.edge());
            crossed.emplace_back(entry.triangle(), exit);
        }
    }

private:
    /// The neighbour of a that lies on the segment, or an invalid id and the edge opposite a that is crossed.
    VertexId leaveStart(std::vector<EdgeLink>& crossed) const
    {
        VertexId neighbour;
        mesh_.forEachTriangleAround(a_, [&](EdgeLink opposite) {
            const VertexId right = mesh_.edgeFrom(opposite);
            const VertexId left = mesh_.edgeTo(opposite);
            if (right == kGhostVertex) return true;
            const Sign rightSide = sideOf(right);
            if (right == b_ || (rightSide == Sign::Zero && isTowardsEnd(right))) {
                neighbour = right;
                return false;
            }
            // Counter-clockwise from the right of the line to its left is ahead, not behind.
            if (left == kGhostVertex || rightSide != Sign::Negative || sideOf(left) != Sign::Positive)
                return true;
            crossed.push_back(opposite);
            return false;
        });
        MESHER_INVARIANT(neighbour.isValid() || !crossed.empty());
        return neighbour;
    }

    [[nodiscard]] Sign sideOf(VertexId v) const { return orient2d(filter_, from_, to_, mesh_.position(v)); }

    /// Of a point on the line through a and b: on b's side of a.
    [[nodiscard]] bool isTowardsEnd(VertexId v) const
    {
        return isLexicographicallyLess(from_, mesh_.position(v)) == isLexicographicallyLess(from_, to_);
    }

    const Triangulation2d& mesh_;
    const StaticFilter2d& filter_;
    VertexId a_;
    VertexId b_;
    Vec2 from_;
    Vec2 to_;
};

std::string nameSegment(VertexId a, VertexId b)
{
    return "segment " + std::to_string(a.value) + "-" + std::to_string(b.value);
}

Error crossingError(const Triangulation2d& mesh, VertexId a, VertexId b, EdgeLink constrained)
{
    const Vec2 from = mesh.position(a);
    const Vec2 direction = mesh.position(b) - from;
    const Vec2 c = mesh.position(mesh.edgeFrom(constrained));
    const Vec2 d = mesh.position(mesh.edgeTo(constrained));
    const double fraction = cross(c - from, d - c) / cross(direction, d - c);
    const Vec2 place = from + fraction * direction;
    Error error;
    error.code = ErrorCode::IntersectingConstraints;
    error.message = "two constraints cross away from a common vertex";
    error.entity =
        nameSegment(a, b) + " and " + nameSegment(mesh.edgeFrom(constrained), mesh.edgeTo(constrained));
    error.point = Vec3{place.x, place.y, 0.0};
    error.remedy = "split both segments where they cross";
    return error;
}

/// Flips the crossed edges at v, a vertex of the strip's left chain between u and w where the strip bulges, until
/// v has none: u and w are joined then.
/// The fan of triangles around v runs from u to w, counter-clockwise. Its farthest vertex on the right of the segment
/// is a convex corner of the fan's outline, so some edge can be flipped as long as one is left.
std::size_t detachFromStrip(Triangulation2d& mesh, const StaticFilter2d& filter, VertexId u, VertexId v,
                            VertexId w)
{
    std::size_t flips = 0;
    const EdgeLink firstSide = mesh.findEdge(v, u);
    EdgeLink fan(firstSide.triangle(), nextCorner(firstSide.edge()));
    for (;;) {
        const VertexId x = mesh.edgeFrom(fan);
        const VertexId y = mesh.edgeTo(fan);
        if (y == w) {
            MESHER_INVARIANT(x == u);
            return flips;
        }
        const EdgeLink spoke(fan.triangle(), nextCorner(fan.edge()));
        const EdgeLink beyond = mesh.across(spoke);
        const VertexId z = mesh.apex(beyond);
        if (orient2d(filter, mesh.position(x), mesh.position(y), mesh.position(z)) != Sign::Positive) {
            fan = EdgeLink(beyond.triangle(), nextCorner(beyond.edge()));
            continue;
        }
        flip(mesh, spoke);
        ++flips;
        fan = EdgeLink(spoke.triangle(), 0);
        if (x == u) continue;
        const EdgeLink before = mesh.across(EdgeLink(fan.triangle(), previousCorner(fan.edge())));
        fan = EdgeLink(before.triangle(), previousCorner(before.edge()));
    }
}

/// Cuts the vertices on the left off the strip of crossed triangles, in the manner of a Graham scan.
std::size_t clearStrip(Triangulation2d& mesh, const StaticFilter2d& filter, VertexId a, VertexId b,
                       SegmentWorkspace2d& workspace)
{
    std::size_t flips = 0;
    std::vector<VertexId>& chain = workspace.chain;
    chain.assign(1, a);
    const auto append = [&](VertexId w) {
        while (chain.size() >= 2) {
            const VertexId u = chain[chain.size() - 2];
            const VertexId v = chain.back();
            if (orient2d(filter, mesh.position(u), mesh.position(v), mesh.position(w)) != Sign::Negative)
                break;
            flips += detachFromStrip(mesh, filter, u, v, w);
            chain.pop_back();
        }
        chain.push_back(w);
    };
    // The left ends of the crossed edges are read before any flip.
    std::vector<VertexId>& leftEnds = workspace.leftEnds;
    leftEnds.clear();
    for (const EdgeLink edge : workspace.crossed) {
        const VertexId left = mesh.edgeTo(edge);
        if (leftEnds.empty() || leftEnds.back() != left) leftEnds.push_back(left);
    }
    for (const VertexId left : leftEnds) append(left);
    append(b);
    MESHER_INVARIANT(chain.size() == 2);
    return flips;
}

void recoverPiece(Triangulation2d& mesh, const StaticFilter2d& filter, VertexId a, VertexId b,
                  SegmentWorkspace2d& workspace, SegmentRecovery2d& result)
{
    workspace.suspects.clear();
    for (std::size_t i = 0; i < workspace.crossed.size(); ++i) {
        const EdgeLink edge = workspace.crossed[i];
        for (unsigned side = 0; side < 3; ++side) workspace.suspects.emplace_back(edge.triangle(), side);
        if (i + 1 < workspace.crossed.size()) continue;
        for (unsigned side = 0; side < 3; ++side)
            workspace.suspects.emplace_back(mesh.across(edge).triangle(), side);
    }
    if (!workspace.crossed.empty()) result.recoveryFlips += clearStrip(mesh, filter, a, b, workspace);
    mesh.setConstrained(mesh.findEdge(a, b), true);
    result.delaunayFlips += restoreDelaunay(mesh, filter, workspace.suspects);
}

}  // namespace

Result<SegmentRecovery2d> recoverSegment(Triangulation2d& mesh, const StaticFilter2d& filter, VertexId a,
                                         VertexId b, SegmentWorkspace2d& workspace)
{
    MESHER_PRECONDITION(mesh.isAlive(a) && mesh.isAlive(b) && a != b);
    std::vector<VertexId>& vertices = workspace.vertices;
    vertices.assign(1, a);
    while (vertices.back() != b) {
        const VertexId next = SegmentTrace(mesh, filter, vertices.back(), b).run(workspace.crossed);
        for (const EdgeLink edge : workspace.crossed) {
            if (mesh.isConstrained(edge)) return crossingError(mesh, a, b, edge);
        }
        vertices.push_back(next);
    }
    SegmentRecovery2d result;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        // With one piece the trace is still at hand.
        if (vertices.size() > 2)
            SegmentTrace(mesh, filter, vertices[i - 1], vertices[i]).run(workspace.crossed);
        recoverPiece(mesh, filter, vertices[i - 1], vertices[i], workspace, result);
    }
    return result;
}

}  // namespace mesher
