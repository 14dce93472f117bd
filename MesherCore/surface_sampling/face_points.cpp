#include "surface_sampling/face_points.h"

namespace mesher {

std::optional<VertexId> insertFacePoint(const BrepFace& face, Vec2 uv, TriangleId hint, FaceTriangulation& t)
{
    const Vec2 plane = t.scaling.toPlane(uv);
    const Location2d location = t.delaunay.locate(plane, hint);
    const bool isFree = location.kind == Location2d::Kind::InTriangle ||
                        (location.kind == Location2d::Kind::OnEdge && !t.mesh().isConstrained(location.edge));
    if (!isFree || !t.isInside(location.triangle())) return std::nullopt;
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
