#include "surface_sampling/face_points.h"

#include <algorithm>

namespace mesher {

namespace {

double squaredDistanceToSide(Vec2 p, Vec2 a, Vec2 b)
{
    const double share = std::clamp(dot(p - a, b - a) / squaredLength(b - a), 0.0, 1.0);
    return squaredLength(p - a - share * (b - a));
}

/// Is the point nearer to a corner or a constrained side of the triangle?
bool isNearer(const Triangulation2d& mesh, TriangleId t, Vec2 p, double squaredDistance)
{
    for (unsigned k = 0; k < 3; ++k) {
        const EdgeLink side(t, k);
        const Vec2 a = mesh.position(mesh.edgeFrom(side)), b = mesh.position(mesh.edgeTo(side));
        if (squaredLength(p - a) < squaredDistance) return true;
        if (mesh.isConstrained(side) && squaredDistanceToSide(p, a, b) < squaredDistance) return true;
    }
    return false;
}

/// Is there a corner or a piece nearer than a share of the longest side about the point? The triangle's neighbours have a say,
/// since the nearest corner may lie just beyond a side.
bool isCramped(const Triangulation2d& mesh, TriangleId t, Vec2 p, double share, double distance)
{
    double longest = 0.0;
    for (unsigned k = 0; k < 3; ++k) {
        const EdgeLink side(t, k);
        longest = std::max(
            longest, squaredLength(mesh.position(mesh.edgeFrom(side)) - mesh.position(mesh.edgeTo(side))));
    }
    const double least = std::max(share * share * longest, distance * distance);
    if (isNearer(mesh, t, p, least)) return true;
    for (unsigned k = 0; k < 3; ++k) {
        const EdgeLink side(t, k);
        if (mesh.isConstrained(side)) continue;
        const TriangleId next = mesh.across(side).triangle();
        if (!mesh.triangle(next).isGhost() && isNearer(mesh, next, p, least)) return true;
    }
    return false;
}

}  // namespace

std::optional<VertexId> insertFacePoint(const BrepFace& face, Vec2 uv, TriangleId hint, FaceTriangulation& t,
                                        double clearance, double leastDistance)
{
    const Vec2 plane = t.scaling.toPlane(uv);
    const Location2d location = t.delaunay.locate(plane, hint);
    const bool isFree = location.kind == Location2d::Kind::InTriangle ||
                        (location.kind == Location2d::Kind::OnEdge && !t.mesh().isConstrained(location.edge));
    if (!isFree || !t.isInside(location.triangle())) return std::nullopt;
    if (isCramped(t.mesh(), location.triangle(), plane, clearance, leastDistance)) return std::nullopt;
    const SurfacePoint exact = face.surface->evaluate(uv);
    if (!isFinite(exact.position)) return std::nullopt;
    auto inserted = t.delaunay.insert(plane, location.triangle());
    if (!inserted || inserted->outcome != InsertOutcome::Inserted) return std::nullopt;
    if (inserted->vertex.value >= t.points.size()) t.points.resize(inserted->vertex.value + 1);
    t.points[inserted->vertex] = {uv, exact.position, FaceTriangulation::unitNormal(exact), {}, false, false};
    return inserted->vertex;
}

std::optional<VertexId> insertPoleImage(VertexId pole, const FacePoint& other, TriangleId hint,
                                        FaceTriangulation& t)
{
    FacePoint image = t.points[pole];
    image.uv = parametersBeside(image, other.uv);
    // The line's own coordinate to the last digit.
    Vec2 plane = t.scaling.toPlane(image.uv);
    if (image.isPoleAlongU) {
        plane.y = t.mesh().position(pole).y;
    } else {
        plane.x = t.mesh().position(pole).x;
    }
    const Location2d location = t.delaunay.locate(plane, hint);
    if (location.kind != Location2d::Kind::OnEdge || !t.mesh().isConstrained(location.edge))
        return std::nullopt;
    const FacePoint& from = t.points[t.mesh().edgeFrom(location.edge)];
    const FacePoint& to = t.points[t.mesh().edgeTo(location.edge)];
    if (!from.isPole || !to.isPole || from.node != image.node || to.node != image.node) return std::nullopt;
    auto inserted = t.delaunay.insert(plane, location.triangle());
    if (!inserted || inserted->outcome != InsertOutcome::SplitConstraint) return std::nullopt;
    if (inserted->vertex.value >= t.points.size()) t.points.resize(inserted->vertex.value + 1);
    t.points[inserted->vertex] = image;
    return inserted->vertex;
}

Vec2 middleOf(const FacePoint& a, const FacePoint& b) { return 0.5 * (a.uv + b.uv); }

Vec2 liftedMiddleOf(const FacePoint& a, const FacePoint& b)
{
    if (a.isPole == b.isPole) return middleOf(a, b);
    const FacePoint &pole = a.isPole ? a : b, &other = a.isPole ? b : a;
    return 0.5 * (parametersBeside(pole, other.uv) + other.uv);
}

Vec2 parametersBeside(const FacePoint& pole, Vec2 others)
{
    return pole.isPoleAlongU ? Vec2{others.x, pole.uv.y} : Vec2{pole.uv.x, others.y};
}

}  // namespace mesher
