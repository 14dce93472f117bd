#include "delaunay/cavity2d.h"

#include "predicates/incircle.h"
#include "predicates/orient2d.h"

#include <algorithm>

namespace mesher {
namespace {

/// A hull edge is in conflict if the point lies strictly outside of it or between its ends.
bool isGhostInConflict(const Triangulation2d& mesh, const StaticFilter2d& filter, const Triangle2d& ghost,
                       Vec2 point)
{
    const Vec2 a = mesh.position(ghost.v[0]);
    const Vec2 b = mesh.position(ghost.v[1]);
    const Sign side = orient2d(filter, a, b, point);
    if (side != Sign::Zero) return side == Sign::Positive;
    return isLexicographicallyLess(a, point) != isLexicographicallyLess(b, point);
}

bool isInConflict(const Triangulation2d& mesh, const StaticFilter2d& filter, const Triangle2d& record,
                  Vec2 point)
{
    if (record.isGhost()) return isGhostInConflict(mesh, filter, record, point);
    return incirclePerturbed(filter, mesh.position(record.v[0]), mesh.position(record.v[1]),
                             mesh.position(record.v[2]), point) == Sign::Positive;
}

void enter(const Triangulation2d& mesh, Cavity2d& cavity, TriangleId t, unsigned throughEdge)
{
    const Triangle2d& record = mesh.triangle(t);
    cavity.triangles.push_back(t);
    cavity.pending.emplace_back(record.n[previousCorner(throughEdge)], record.region);
    cavity.pending.emplace_back(record.n[nextCorner(throughEdge)], record.region);
}

/// The search proper, depth first and counter-clockwise, so that the boundary comes out in order.
template <bool hasExclusions>
void search(const Triangulation2d& mesh, const StaticFilter2d& filter, Cavity2d& cavity)
{
    const auto isExcluded = [&](TriangleId t) {
        return std::find(cavity.excluded.begin(), cavity.excluded.end(), t) != cavity.excluded.end();
    };
    const Vec2 point = cavity.point;
    while (!cavity.pending.empty()) {
        EdgeLink side = cavity.pending.back().side();
        RegionId region = cavity.pending.back().region();
        cavity.pending.pop_back();
        for (;;) {
            const Triangle2d& next = mesh.triangle(side.triangle());
            const bool isConstrained = next.isConstrained(side.edge());
            bool isOuter = isConstrained || !isInConflict(mesh, filter, next, point);
            if constexpr (hasExclusions) isOuter = isOuter || isExcluded(side.triangle());
            if (isOuter) {
                cavity.boundary.push_back({side, region});
                if (isConstrained) cavity.constrained.push_back(side);
                break;
            }
            // On to the next edge; the one after it waits.
            cavity.triangles.push_back(side.triangle());
            MESHER_INVARIANT(cavity.triangles.size() <= mesh.triangleCount());
            region = next.region;
            cavity.pending.emplace_back(next.n[previousCorner(side.edge())], region);
            side = next.n[nextCorner(side.edge())];
        }
    }
}

void collect(const Triangulation2d& mesh, const StaticFilter2d& filter, Cavity2d& cavity)
{
    cavity.triangles.clear();
    cavity.boundary.clear();
    cavity.constrained.clear();
    cavity.pending.clear();
    const TriangleId start = cavity.location.triangle();
    const Triangle2d& record = mesh.triangle(start);
    unsigned firstEdge = 0;
    if (cavity.location.kind == Location2d::Kind::OnEdge) {
        // The edge the point lies on goes, be it constrained or not: both its sides are entered.
        firstEdge = cavity.location.index();
        enter(mesh, cavity, record.n[firstEdge].triangle(), record.n[firstEdge].edge());
    } else {
        cavity.pending.emplace_back(record.n[firstEdge], record.region);
    }
    enter(mesh, cavity, start, firstEdge);
    if (cavity.excluded.empty()) {
        search<false>(mesh, filter, cavity);
    } else {
        search<true>(mesh, filter, cavity);
    }
}

/// Excludes the inner triangles of boundary edges that the point does not see; false if there are none.
bool excludeInvisible(const Triangulation2d& mesh, const StaticFilter2d& filter, Cavity2d& cavity)
{
    const std::size_t before = cavity.excluded.size();
    for (const Cavity2d::BoundaryEdge& edge : cavity.boundary) {
        const VertexId from = mesh.edgeTo(edge.outer);
        const VertexId to = mesh.edgeFrom(edge.outer);
        if (from == kGhostVertex || to == kGhostVertex) continue;
        if (orient2d(filter, mesh.position(from), mesh.position(to), cavity.point) == Sign::Positive)
            continue;
        cavity.excluded.push_back(mesh.across(edge.outer).triangle());
    }
    return cavity.excluded.size() != before;
}

/// Turns the corners of the triangle forward by one, its links and those of its neighbours following.
void turnCorners(Triangulation2d& mesh, TriangleId t)
{
    Triangle2d& record = mesh.triangle(t);
    std::rotate(record.v, record.v + 2, record.v + 3);
    std::rotate(record.n, record.n + 2, record.n + 3);
    const unsigned constrained = record.flags & Triangle2d::kConstrainedEdges;
    const unsigned turned = (constrained << 1 | constrained >> 2) & Triangle2d::kConstrainedEdges;
    record.flags = static_cast<std::uint16_t>((record.flags & ~Triangle2d::kConstrainedEdges) | turned);
    for (unsigned edge = 0; edge < 3; ++edge) mesh.link(record.n[edge], EdgeLink(t, edge));
}

/// Marks the two halves of the constrained edge that the new vertex splits.
void constrainHalves(Triangulation2d& mesh, VertexId vertex, VertexId from, VertexId to)
{
    mesh.setConstrained(mesh.findEdge(vertex, from), true);
    mesh.setConstrained(mesh.findEdge(vertex, to), true);
}

}  // namespace

void findCavity(const Triangulation2d& mesh, const StaticFilter2d& filter, Vec2 point,
                const Location2d& location, StarCheck check, Cavity2d& cavity)
{
    MESHER_PRECONDITION(location.kind == Location2d::Kind::InTriangle ||
                        location.kind == Location2d::Kind::OnEdge ||
                        location.kind == Location2d::Kind::OutsideHull);
    cavity.point = point;
    cavity.location = location;
    cavity.excluded.clear();
    do {
        collect(mesh, filter, cavity);
    } while (check == StarCheck::Repair && excludeInvisible(mesh, filter, cavity));
    cavity.repairs = static_cast<unsigned>(cavity.excluded.size());
}

TriangleId commitCavity(Triangulation2d& mesh, const Cavity2d& cavity, VertexId vertex)
{
    MESHER_PRECONDITION(mesh.position(vertex) == cavity.point);
    const bool splitsConstraint =
        cavity.location.kind == Location2d::Kind::OnEdge && mesh.isConstrained(cavity.location.edge);
    const VertexId splitFrom = splitsConstraint ? mesh.edgeFrom(cavity.location.edge) : VertexId();
    const VertexId splitTo = splitsConstraint ? mesh.edgeTo(cavity.location.edge) : VertexId();

    const std::size_t count = cavity.boundary.size();
    const std::size_t reused = cavity.triangles.size();
    MESHER_INVARIANT(count == reused + 2);
    const TriangleId extra[2] = {mesh.allocateTriangle(), mesh.allocateTriangle()};
    const auto slot = [&](std::size_t i) { return i < reused ? cavity.triangles[i] : extra[i - reused]; };

    TriangleId previous = slot(count - 1);
    TriangleId current = slot(0);
    TriangleId turned;
    for (std::size_t i = 0; i < count; ++i) {
        const TriangleId next = slot(i + 1 == count ? 0 : i + 1);
        const EdgeLink outer = cavity.boundary[i].outer;
        Triangle2d& neighbour = mesh.triangle(outer.triangle());
        neighbour.n[outer.edge()] = EdgeLink(current, 0);
        const VertexId from = neighbour.v[previousCorner(outer.edge())];
        const VertexId to = neighbour.v[nextCorner(outer.edge())];

        Triangle2d& record = mesh.triangle(current);
        record.v[0] = vertex;
        record.v[1] = from;
        record.v[2] = to;
        record.n[0] = outer;
        record.n[1] = EdgeLink(next, 2);
        record.n[2] = EdgeLink(previous, 1);
        record.flags = neighbour.isConstrained(outer.edge()) ? 1 : 0;
        ++record.generation;
        record.region = cavity.boundary[i].region;
        if (from != kGhostVertex) {
            mesh.setTriangleAt(from, current);
        } else {
            turned = current;
        }
        previous = current;
        current = next;
    }
    mesh.setTriangleAt(vertex, slot(0));
    if (turned.isValid()) turnCorners(mesh, turned);
    if (splitsConstraint) constrainHalves(mesh, vertex, splitFrom, splitTo);
    return previous;
}

}  // namespace mesher
