#include "surface_sampling/face_walk.h"

#include "surface_sampling/facet_measures.h"

namespace mesher {
namespace {

constexpr int kMostTriangles = 200;

}  // namespace

FaceWalk walkToPoint(const FaceMesh& mesh, const FaceGeometry& geometry, TriangleId start, const Vec3& point)
{
    const FaceTriangle& first = mesh.triangle(start);
    const Vec3 &a = mesh.position(first.v[0]), &b = mesh.position(first.v[1]), &c = mesh.position(first.v[2]);
    const Vec3 centroid = (1.0 / 3.0) * (a + b + c);
    // Points in front of this vector lie to the left of the walk.
    const Vec3 left = cross(cross(b - a, c - a), point - centroid);
    const auto isLeft = [&](VertexId v) { return dot(mesh.position(v) - centroid, left) >= 0.0; };

    FaceWalk walk;
    walk.triangle = start;
    bool isBeyond = false;
    for (unsigned i = 0; i < 3; ++i) isBeyond = isBeyond || sideOfEdge(mesh, EdgeLink(start, i), point) < 0.0;
    if (!isBeyond) {
        walk.outcome = FaceWalk::Outcome::Inside;
        return walk;
    }
    EdgeLink exit;
    for (unsigned i = 0; i < 3; ++i) {
        const EdgeLink side(start, i);
        if (!isLeft(mesh.from(side)) && isLeft(mesh.to(side))) exit = side;
    }
    for (int step = 0; exit.isValid() && step < kMostTriangles; ++step) {
        if (sideOfEdge(mesh, exit, point) >= 0.0) {
            walk.outcome = FaceWalk::Outcome::Inside;
            walk.triangle = exit.triangle();
            return walk;
        }
        if (mesh.segment(exit).isValid()) {
            walk.outcome = FaceWalk::Outcome::Blocked;
            walk.triangle = exit.triangle();
            walk.side = exit;
            return walk;
        }
        if (mesh.isOnRing(exit)) return walk;
        walk.shift = walk.shift + mesh.shiftAcross(geometry, exit);
        const EdgeLink entry = mesh.across(exit);
        const unsigned next =
            isLeft(mesh.apex(entry)) ? nextCorner(entry.edge()) : previousCorner(entry.edge());
        exit = EdgeLink(entry.triangle(), next);
    }
    return walk;
}

}  // namespace mesher
