#include "surface_sampling/face_folds.h"

#include <algorithm>

namespace mesher {

namespace {

// Heights below this share of the longest side are zero but for rounding: two corners are one place, or on one way to a pole.
constexpr double kFlat = 1e-8;

Vec3 areaVectorOf(const std::array<const FacePoint*, 3>& corners)
{
    const auto& [a, b, c] = corners;
    return cross(b->position - a->position, c->position - a->position);
}

}  // namespace

bool isUpright(const std::array<const FacePoint*, 3>& corners)
{
    const Vec3 normal = areaVectorOf(corners);
    return squaredLength(normal) > 0.0 &&
           std::all_of(corners.begin(), corners.end(), [&](const FacePoint* point) {
               return point->normal == Vec3{} || dot(normal, point->normal) > 0.0;
           });
}

bool isWithinTolerance(const BrepFace& face, const std::array<const FacePoint*, 3>& corners)
{
    const Vec3 &a = corners[0]->position, &b = corners[1]->position, &c = corners[2]->position;
    const double longest = std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
    const double squaredArea = squaredLength(areaVectorOf(corners));
    return squaredArea < face.tolerance * face.tolerance * longest &&
           squaredArea > kFlat * kFlat * longest * longest;
}

bool isOnPiece(const BrepFace& face, const FaceTriangulation& t, Vec2 uv, TriangleId hint)
{
    const Location2d location = t.delaunay.locate(t.scaling.toPlane(uv), hint);
    if (location.kind != Location2d::Kind::InTriangle) return false;
    const Vec3 place = face.surface->position(uv);
    for (unsigned k = 0; k < 3; ++k) {
        const EdgeLink side(location.triangle(), k);
        if (!t.mesh().isConstrained(side)) continue;
        // The distance from the line: points just beyond the end of a piece are as bad.
        const Vec3& a = t.points[t.mesh().edgeFrom(side)].position;
        const Vec3& b = t.points[t.mesh().edgeTo(side)].position;
        const double squaredReach = face.tolerance * face.tolerance * squaredLength(b - a);
        if (squaredLength(cross(place - a, b - a)) < squaredReach) return true;
    }
    return false;
}

}  // namespace mesher
