#pragma once

#include "base/vec.h"
#include "surface_sampling/face_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// Small questions about facets and edges of a face's mesh that several steps ask.
namespace mesher {

/// The least cosine between the normal of a facet and the normals of the surface at its corners; corners without a normal do
/// not count. -1 for a facet without area.
[[nodiscard]] inline double normalAgreement(const FaceVertex& a, const FaceVertex& b, const FaceVertex& c)
{
    const Vec3 normal = cross(b.position - a.position, c.position - a.position);
    const double size = length(normal);
    if (!(size > 0.0)) return -1.0;
    double least = size;
    for (const FaceVertex* corner : {&a, &b, &c}) {
        if (corner->normal == Vec3{}) continue;
        least = std::min(least, dot(normal, corner->normal));
    }
    return least / size;
}

/// As `normalAgreement`, and below any of its values for a facet that is flat or clockwise in the parameters: three nodes of
/// one straight edge have a normal by rounding only. A pole's parameters tell nothing.
[[nodiscard]] inline double facetAgreement(const FaceGeometry& geometry, const FaceVertex& a, Vec2 uvA,
                                           const FaceVertex& b, Vec2 uvB, const FaceVertex& c, Vec2 uvC)
{
    constexpr double kTurnedOver = -2.0;
    const bool isAtPole = a.isPole() || b.isPole() || c.isPole();
    if (!isAtPole && !geometry.isCounterClockwise(uvA, uvB, uvC)) return kTurnedOver;
    return normalAgreement(a, b, c);
}

/// That of a triangle of the mesh.
[[nodiscard]] inline double facetAgreement(const FaceGeometry& geometry, const FaceMesh& mesh, TriangleId t)
{
    const FaceTriangle& record = mesh.triangle(t);
    return facetAgreement(geometry, mesh.vertex(record.v[0]), record.uv[0], mesh.vertex(record.v[1]),
                          record.uv[1], mesh.vertex(record.v[2]), record.uv[2]);
}

/// By how much the angles under which `c` and `d`, on its two sides, see the edge ab sum up to more than 180 degrees, in a
/// unit that is about radians. Positive iff the edge is not locally Delaunay in the two triangles laid flat.
[[nodiscard]] inline double oppositeAngleExcess(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 ca = a - c, cb = b - c, da = a - d, db = b - d;
    const double cosineC = dot(ca, cb), cosineD = dot(da, db);
    // Two acute angles never sum up to that much.
    if (cosineC > 0.0 && cosineD > 0.0) return -1.0;
    const double sineC = length(cross(ca, cb)), sineD = length(cross(da, db));
    const double scale = (sineC + std::abs(cosineC)) * (sineD + std::abs(cosineD));
    return scale > 0.0 ? -(sineC * cosineD + cosineC * sineD) / scale : -1.0;
}

/// Excess that is taken for a tie: then the edge stays.
inline constexpr double kDelaunayTie = 1e-9;

/// The sine of the angle by which p lies to the left of the side's vertical plane, times |ab||ap|: positive inside. The
/// plane contains the edge and the surface's normals at its ends, so both triangles of an edge agree about it.
[[nodiscard]] inline double sideOfEdge(const FaceMesh& mesh, EdgeLink side, const Vec3& p)
{
    const FaceVertex& a = mesh.vertex(mesh.from(side));
    const FaceVertex& b = mesh.vertex(mesh.to(side));
    Vec3 up = a.normal + b.normal;
    if (up == Vec3{}) {
        up = cross(b.position - a.position, mesh.position(mesh.apex(side)) - a.position);
    }
    return dot(cross(b.position - a.position, p - a.position), up);
}

struct FacetShape
{
    double squaredRadius = 0.0;  ///< of the circumscribed circle
    std::array<double, 3> squaredSide{};
    unsigned shortest = 0;
    unsigned longest = 0;

    [[nodiscard]] double longestSquared() const { return squaredSide[longest]; }

    /// Circumradius by shortest edge: 1 / (2 sin of the smallest angle).
    [[nodiscard]] double squaredRatio() const { return squaredRadius / squaredSide[shortest]; }

    [[nodiscard]] static FacetShape of(const Vec3& a, const Vec3& b, const Vec3& c)
    {
        FacetShape shape;
        shape.squaredSide = {squaredLength(c - b), squaredLength(a - c), squaredLength(b - a)};
        const auto& s = shape.squaredSide;
        shape.shortest = s[1] < s[0] ? 1 : 0;
        if (s[2] < s[shape.shortest]) shape.shortest = 2;
        shape.longest = s[1] > s[0] ? 1 : 0;
        if (s[2] > s[shape.longest]) shape.longest = 2;
        const double area = 4.0 * squaredLength(cross(b - a, c - a));
        shape.squaredRadius =
            area > 0.0 ? s[0] * s[1] * s[2] / area : std::numeric_limits<double>::infinity();
        return shape;
    }
};

/// Height over longest side below which a facet is flat: above, it takes few more to make it good.
inline constexpr double kFlatFacet = 0.25;

[[nodiscard]] inline bool isFlatFacet(const FaceMesh& mesh, TriangleId t)
{
    const auto& v = mesh.triangle(t).v;
    const Vec3 &a = mesh.position(v[0]), &b = mesh.position(v[1]), &c = mesh.position(v[2]);
    const double squaredLongest =
        std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
    return length(cross(b - a, c - a)) < kFlatFacet * squaredLongest;
}

}  // namespace mesher
