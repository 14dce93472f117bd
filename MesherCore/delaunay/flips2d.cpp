#include "delaunay/flips2d.h"

#include "predicates/incircle.h"

namespace mesher {
namespace {

/// What surrounds a quadrilateral: an outer side and whether it is constrained.
struct OuterSide
{
    EdgeLink link;
    bool isConstrained;

    OuterSide(const Triangle2d& record, unsigned edge)
        : link(record.n[edge]), isConstrained(record.isConstrained(edge))
    {
    }
};

void write(Triangulation2d& mesh, TriangleId t, const VertexId (&corners)[3], EdgeLink diagonal,
           const OuterSide& one, const OuterSide& two)
{
    Triangle2d& record = mesh.triangle(t);
    for (unsigned i = 0; i < 3; ++i) record.v[i] = corners[i];
    record.n[0] = diagonal;
    mesh.link(EdgeLink(t, 1), one.link);
    mesh.link(EdgeLink(t, 2), two.link);
    const unsigned marks = record.flags & ~unsigned{Triangle2d::kConstrainedEdges};
    record.flags =
        static_cast<std::uint16_t>(marks | (one.isConstrained ? 2u : 0u) | (two.isConstrained ? 4u : 0u));
    ++record.generation;
    for (const VertexId corner : corners) mesh.setTriangleAt(corner, t);
}

}  // namespace

EdgeLink flip(Triangulation2d& mesh, EdgeLink edge)
{
    const EdgeLink other = mesh.across(edge);
    const TriangleId t = edge.triangle();
    const TriangleId s = other.triangle();
    MESHER_PRECONDITION(!mesh.isConstrained(edge));
    MESHER_PRECONDITION(!mesh.triangle(t).isGhost() && !mesh.triangle(s).isGhost());

    const VertexId near = mesh.apex(edge);
    const VertexId far = mesh.apex(other);
    const VertexId from = mesh.edgeFrom(edge);
    const VertexId to = mesh.edgeTo(edge);
    // The quadrilateral is near, from, far, to, counter-clockwise.
    const OuterSide nearFrom(mesh.triangle(t), previousCorner(edge.edge()));
    const OuterSide toNear(mesh.triangle(t), nextCorner(edge.edge()));
    const OuterSide fromFar(mesh.triangle(s), nextCorner(other.edge()));
    const OuterSide farTo(mesh.triangle(s), previousCorner(other.edge()));

    mesh.triangle(s).region = mesh.triangle(t).region;
    write(mesh, t, {to, near, far}, EdgeLink(s, 0), farTo, toNear);
    write(mesh, s, {from, far, near}, EdgeLink(t, 0), nearFrom, fromFar);
    return EdgeLink(t, 0);
}

bool isLocallyDelaunay(const Triangulation2d& mesh, const StaticFilter2d& filter, EdgeLink edge)
{
    const Triangle2d& record = mesh.triangle(edge.triangle());
    if (record.isConstrained(edge.edge()) || record.isGhost()) return true;
    const EdgeLink other = record.n[edge.edge()];
    if (mesh.triangle(other.triangle()).isGhost()) return true;
    return incirclePerturbed(filter, mesh.position(record.v[0]), mesh.position(record.v[1]),
                             mesh.position(record.v[2]), mesh.position(mesh.apex(other))) != Sign::Positive;
}

std::size_t restoreDelaunay(Triangulation2d& mesh, const StaticFilter2d& filter,
                            std::vector<EdgeLink>& suspects)
{
    std::size_t flips = 0;
    while (!suspects.empty()) {
        const EdgeLink edge = suspects.back();
        suspects.pop_back();
        if (isLocallyDelaunay(mesh, filter, edge)) continue;
        const EdgeLink diagonal = flip(mesh, edge);
        ++flips;
        for (const EdgeLink side : {diagonal, mesh.across(diagonal)}) {
            suspects.emplace_back(side.triangle(), 1u);
            suspects.emplace_back(side.triangle(), 2u);
        }
    }
    return flips;
}

}  // namespace mesher
