#include "triangulation2d/straight_walk2d.h"

#include "predicates/orient2d.h"

namespace mesher {

StraightWalk2d walkStraight(const Triangulation2d& mesh, const StaticFilter2d& filter, TriangleId start,
                            Vec2 point)
{
    constexpr int kMaxSteps = 100000;
    constexpr unsigned kNowhere = 3;
    StraightWalk2d result;
    const Triangle2d& first = mesh.triangle(start);
    const Vec2 sum = mesh.position(first.v[0]) + mesh.position(first.v[1]) + mesh.position(first.v[2]);
    const Vec2 origin = (1.0 / 3.0) * sum;
    TriangleId t = start;
    unsigned entered = kNowhere;
    for (int step = 0; step < kMaxSteps; ++step) {
        const Triangle2d& record = mesh.triangle(t);
        if (record.isGhost()) return result;
        const Vec2 corners[3] = {mesh.position(record.v[0]), mesh.position(record.v[1]),
                                 mesh.position(record.v[2])};
        Sign sides[3] = {Sign::Positive, Sign::Positive, Sign::Positive};
        unsigned beyond[2] = {kNowhere, kNowhere};
        unsigned count = 0;
        for (unsigned edge = 0; edge < 3; ++edge) {
            if (edge == entered) continue;
            sides[edge] = orient2d(filter, corners[nextCorner(edge)], corners[previousCorner(edge)], point);
            if (sides[edge] == Sign::Negative) beyond[count++] = edge;
        }
        if (count == 0) {
            unsigned zero = 0;
            unsigned zeros = 0;
            for (unsigned edge = 0; edge < 3; ++edge) {
                if (sides[edge] != Sign::Zero) continue;
                zero = zeros == 0 ? edge : 3 - zero - edge;
                ++zeros;
            }
            result.outcome = StraightWalk2d::Outcome::Found;
            result.location.kind = zeros == 0   ? Location2d::Kind::InTriangle
                                   : zeros == 1 ? Location2d::Kind::OnEdge
                                                : Location2d::Kind::OnVertex;
            result.location.edge = EdgeLink(t, zero);
            return result;
        }
        unsigned exit = beyond[0];
        if (count == 2) {
            // Both edges meet in the third edge's opposite corner; the line passes it on one side.
            const unsigned corner = 3 - beyond[0] - beyond[1];
            const bool cornerIsLeft = orient2d(filter, origin, point, corners[corner]) != Sign::Negative;
            // Seen towards the corner, the edge opposite of the next corner is the right one.
            exit = cornerIsLeft ? nextCorner(corner) : previousCorner(corner);
        }
        if (record.isConstrained(exit)) {
            result.outcome = StraightWalk2d::Outcome::Blocked;
            result.blocker = EdgeLink(t, exit);
            return result;
        }
        entered = record.n[exit].edge();
        t = record.n[exit].triangle();
    }
    return result;
}

}  // namespace mesher
