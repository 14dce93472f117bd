#include "predicates/circumcenter.h"

namespace mesher {

// All three solve 2 k . u = |u|^2 for the edge vectors u at vertex a; k is the centre relative to a.

std::optional<Vec2> approximateCircumcenter(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const Vec2 u = b - a;
    const Vec2 v = c - a;
    const double determinant = cross(u, v);
    if (determinant == 0.0) return std::nullopt;
    const Vec2 numerator = squaredLength(u) * Vec2{v.y, -v.x} - squaredLength(v) * Vec2{u.y, -u.x};
    return a + (0.5 / determinant) * numerator;
}

std::optional<Vec3> approximateCircumcenter(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const Vec3 normal = cross(u, v);
    const double squaredArea = squaredLength(normal);
    if (squaredArea == 0.0) return std::nullopt;
    const Vec3 numerator = cross(squaredLength(u) * v - squaredLength(v) * u, normal);
    return a + (0.5 / squaredArea) * numerator;
}

std::optional<Vec3> approximateCircumcenter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const Vec3 w = d - a;
    const Vec3 normal = cross(v, w);
    const double determinant = dot(u, normal);
    if (determinant == 0.0) return std::nullopt;
    const Vec3 numerator =
        squaredLength(u) * normal + squaredLength(v) * cross(w, u) + squaredLength(w) * cross(u, v);
    return a + (0.5 / determinant) * numerator;
}

}  // namespace mesher
