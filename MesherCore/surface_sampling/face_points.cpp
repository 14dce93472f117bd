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

Vec2 middleOf(const FacePoint& a, const FacePoint& b) { return 0.5 * (a.uv + b.uv); }

Vec2 parametersBeside(const FacePoint& pole, Vec2 others)
{
    return pole.isPoleAlongU ? Vec2{others.x, pole.uv.y} : Vec2{pole.uv.x, others.y};
}

}  // namespace mesher
