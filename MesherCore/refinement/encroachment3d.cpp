#include "refinement/encroachment3d.h"

#include "predicates/circumcenter.h"
#include "predicates/orient3d.h"

namespace mesher {

ProtectingBall ProtectingBall::ofSegment(const Vec3& a, const Vec3& b)
{
    return {0.5 * (a + b), 0.25 * squaredLength(b - a)};
}

std::optional<ProtectingBall> ProtectingBall::ofFacet(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const std::optional<Vec3> centre = approximateCircumcenter(a, b, c);
    if (!centre) return std::nullopt;
    return ProtectingBall{*centre, squaredLength(a - *centre)};
}

namespace {

void findEncroachedSegment(const Triangulation3d& mesh, const Cavity3d& conflicts, Encroached3d& found)
{
    double deepest = 1.0;
    for (const TetId tet : conflicts.tets) {
        if ((mesh.flags(tet) & tet_flag::kEdges) == 0 || mesh.isGhostTet(tet)) continue;
        for (int edge = 0; edge < 6; ++edge) {
            if (!mesh.isEdgeConstrained(tet, edge)) continue;
            const VertexId a = mesh.vertex(tet, kEdgeSlots[edge][0]);
            const VertexId b = mesh.vertex(tet, kEdgeSlots[edge][1]);
            const ProtectingBall ball = ProtectingBall::ofSegment(mesh.position(a), mesh.position(b));
            const double depth = ball.depthOf(conflicts.point);
            if (!ball.contains(conflicts.point) || depth >= deepest) continue;
            deepest = depth;
            found.segment = {std::min(a, b), std::max(a, b)};
        }
    }
}

}  // namespace

Encroached3d findEncroached(const Triangulation3d& mesh, const Cavity3d& conflicts,
                            const StaticFilter3d& filter)
{
    Encroached3d found;
    findEncroachedSegment(mesh, conflicts, found);
    double deepest = 1.0;
    for (const TetFace outer : conflicts.constrainedFaces) {
        const auto v = mesh.faceVertices(mesh.neighbour(outer));
        if (isGhost(v[0]) || isGhost(v[1]) || isGhost(v[2])) continue;
        const Vec3& a = mesh.position(v[0]);
        const Vec3& b = mesh.position(v[1]);
        const Vec3& c = mesh.position(v[2]);
        const Sign side = orient3d(filter, a, b, c, conflicts.point);
        if (side != Sign::Positive) found.hasFacetBehind = true;
        // In the plane of a facet the point can be in it.
        if (side == Sign::Negative) continue;
        const std::optional<ProtectingBall> ball = ProtectingBall::ofFacet(a, b, c);
        if (!ball || !ball->contains(conflicts.point)) continue;
        const double depth = ball->depthOf(conflicts.point);
        if (depth >= deepest) continue;
        deepest = depth;
        found.facet = outer;
    }
    return found;
}

TetFace firstConstraintTowards(const Triangulation3d& mesh, TetId from, const Vec3& point,
                               const StaticFilter3d& filter)
{
    constexpr int kMostSteps = 10000;
    Vec3 start;
    for (const VertexId v : mesh.tet(from).vertex) start = start + 0.25 * mesh.position(v);
    TetId tet = from;
    int entered = -1;
    for (int step = 0; step < kMostSteps && !mesh.isGhostTet(tet); ++step) {
        int exit = -1;
        for (int face = 0; face < 4 && exit < 0; ++face) {
            if (face == entered) continue;
            const auto [f0, f1, f2] = mesh.faceVertices({tet, face});
            const Vec3& a = mesh.position(f0);
            const Vec3& b = mesh.position(f1);
            const Vec3& c = mesh.position(f2);
            if (orient3d(filter, a, b, c, point) != Sign::Negative) continue;
            // The line leaves through the face whose three edges it passes on the same side.
            const bool isCrossed = orient3d(filter, start, point, a, b) != Sign::Positive &&
                                   orient3d(filter, start, point, b, c) != Sign::Positive &&
                                   orient3d(filter, start, point, c, a) != Sign::Positive;
            const bool isCrossedReversed = orient3d(filter, start, point, a, b) != Sign::Negative &&
                                           orient3d(filter, start, point, b, c) != Sign::Negative &&
                                           orient3d(filter, start, point, c, a) != Sign::Negative;
            if (isCrossed || isCrossedReversed) exit = face;
        }
        if (exit < 0) return {};
        const TetFace crossed(tet, exit);
        if (mesh.isFaceConstrained(crossed)) return crossed;
        const TetFace next = mesh.neighbour(crossed);
        tet = next.tet();
        entered = next.face();
    }
    return {};
}

Encroached3d findInTheWay(Delaunay3d& delaunay, TetId tet, const Vec3& point)
{
    const Triangulation3d& mesh = delaunay.triangulation();
    const Cavity3d* conflicts = &delaunay.findConflicts(point, tet, kOrdinaryConflicts);
    if (conflicts->isCut) {
        const TetFace blocking = firstConstraintTowards(mesh, tet, point, delaunay.filter());
        if (blocking.isValid()) return {{}, blocking, true};
        conflicts = &delaunay.findConflicts(point, tet);
    }
    Encroached3d found = findEncroached(mesh, *conflicts, delaunay.filter());
    const bool isFree = !found.segment[0].isValid() && !found.facet.isValid();
    if (isFree && found.hasFacetBehind)
        found.facet = firstConstraintTowards(mesh, tet, point, delaunay.filter());
    return found;
}

}  // namespace mesher
