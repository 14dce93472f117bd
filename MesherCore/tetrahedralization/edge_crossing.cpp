#include "tetrahedralization/edge_crossing.h"

#include "predicates/orient3d.h"

#include <algorithm>
#include <cmath>

namespace mesher {

bool EdgeCrossings::isSame(const EdgeCrossing& first, const EdgeCrossing& second)
{
    if (first.kind != second.kind) return false;
    return std::is_permutation(first.vertex.begin(), first.vertex.end(), second.vertex.begin());
}

/// The faces through which the line can leave the tetrahedra around the place it has come to.
void EdgeCrossings::listCandidates(const EdgeCrossing& at)
{
    candidates_.clear();
    switch (at.kind) {
        case EdgeCrossing::Kind::Vertex:
            mesh_.collectStar(at.vertex[0], tets_);
            for (const TetId tet : tets_) candidates_.push_back({tet, mesh_.slotOf(tet, at.vertex[0])});
            break;
        case EdgeCrossing::Kind::Edge:
            mesh_.collectEdgeRing(at.face.tet(), at.vertex[0], at.vertex[1], tets_);
            for (const TetId tet : tets_) {
                candidates_.push_back({tet, mesh_.slotOf(tet, at.vertex[0])});
                candidates_.push_back({tet, mesh_.slotOf(tet, at.vertex[1])});
            }
            break;
        case EdgeCrossing::Kind::Face: {
            const TetFace behind = mesh_.neighbour(at.face);
            for (int face = 0; face < 4; ++face) {
                if (face != behind.face()) candidates_.push_back({behind.tet(), face});
            }
            break;
        }
    }
}

/// How the segment meets a closed triangle that its start does not lie on.
bool EdgeCrossings::hit(TetFace face, EdgeCrossing& crossing) const
{
    const auto corner = mesh_.faceVertices(face);
    if (isGhost(corner[0]) || isGhost(corner[1]) || isGhost(corner[2])) return false;
    const Vec3& a = mesh_.position(from_);
    const Vec3& b = mesh_.position(to_);
    const Vec3* p[3];
    for (unsigned k = 0; k < 3; ++k) p[k] = &mesh_.position(corner[k]);
    const Sign sideOfStart = orient3d(*p[0], *p[1], *p[2], a);
    if (sideOfStart == Sign::Zero || sideOfStart == orient3d(*p[0], *p[1], *p[2], b)) return false;
    Sign around = Sign::Zero;
    int zeros = 0;
    bool isZero[3];
    for (unsigned k = 0; k < 3; ++k) {
        const Sign sign = orient3d(a, b, *p[(k + 1) % 3], *p[(k + 2) % 3]);
        isZero[k] = sign == Sign::Zero;
        zeros += isZero[k] ? 1 : 0;
        if (isZero[k]) continue;
        if (around != Sign::Zero && sign != around) return false;
        around = sign;
    }
    crossing.face = face;
    crossing.vertex = {};
    if (zeros == 0) {
        crossing.kind = EdgeCrossing::Kind::Face;
        crossing.vertex = corner;
    } else if (zeros == 1) {
        crossing.kind = EdgeCrossing::Kind::Edge;
        const unsigned k = isZero[0] ? 0 : (isZero[1] ? 1 : 2);
        crossing.vertex[0] = corner[(k + 1) % 3];
        crossing.vertex[1] = corner[(k + 2) % 3];
    } else {
        crossing.kind = EdgeCrossing::Kind::Vertex;
        crossing.vertex[0] = corner[!isZero[0] ? 0 : (!isZero[1] ? 1 : 2)];
    }
    return true;
}

void EdgeCrossings::find(VertexId a, VertexId b, std::vector<EdgeCrossing>& crossings)
{
    crossings.clear();
    from_ = a;
    to_ = b;
    EdgeCrossing previous;
    EdgeCrossing current{EdgeCrossing::Kind::Vertex, {}, {a, {}, {}}};
    while (true) {
        listCandidates(current);
        EdgeCrossing next;
        bool isFound = false;
        for (const Candidate& candidate : candidates_) {
            if (current.kind == EdgeCrossing::Kind::Vertex && mesh_.slotOf(candidate.tet, b) >= 0) return;
            if (mesh_.isGhostTet(candidate.tet) || !hit({candidate.tet, candidate.face}, next)) continue;
            if (isSame(next, previous) || isSame(next, current)) continue;
            isFound = true;
            break;
        }
        MESHER_INVARIANT(isFound);
        if (!isFound) return;
        if (next.kind == EdgeCrossing::Kind::Vertex && next.vertex[0] == b) return;
        crossings.push_back(next);
        if (next.kind == EdgeCrossing::Kind::Vertex) return;
        previous = current;
        current = next;
    }
}

double clampedShare(double part, double whole)
{
    // Rounding may leave nothing of a line that is nearly in the plane that it crosses.
    const double share = part / whole;
    return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5;
}

Vec3 crossingPoint(const Triangulation3d& mesh, VertexId a, VertexId b, const EdgeCrossing& crossing)
{
    const Vec3 from = mesh.position(a);
    const Vec3 direction = mesh.position(b) - from;
    const Vec3 first = mesh.position(crossing.vertex[0]);
    if (crossing.kind == EdgeCrossing::Kind::Vertex) return first;
    const Vec3 side = mesh.position(crossing.vertex[1]) - first;
    Vec3 normal;
    if (crossing.kind == EdgeCrossing::Kind::Face) {
        normal = cross(side, mesh.position(crossing.vertex[2]) - first);
    } else {
        // The plane that has the edge and is as square to the line as can be.
        normal = cross(side, cross(direction, side));
    }
    return from + clampedShare(dot(normal, first - from), dot(normal, direction)) * direction;
}

}  // namespace mesher
