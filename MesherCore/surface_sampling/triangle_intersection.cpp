#include "surface_sampling/triangle_intersection.h"

#include "predicates/orient2d.h"
#include "predicates/orient3d.h"

namespace mesher {
namespace {

/// Leaves out one coordinate.
Vec2 flat(const Vec3& p, int axis)
{
    return axis == 0 ? Vec2{p.y, p.z} : (axis == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y});
}

/// A coordinate without which the triangle keeps an area; leaving it out keeps orientations of coplanar points, but for one
/// sign for all.
int projectionAxis(const TrianglePoints& t)
{
    for (int axis = 2; axis > 0; --axis) {
        if (orient2d(flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)) != Sign::Zero) return axis;
    }
    return 0;
}

bool isOnSegment(Vec2 a, Vec2 b, Vec2 p)
{
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool doSegmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const Sign abc = orient2d(a, b, c), abd = orient2d(a, b, d);
    const Sign cda = orient2d(c, d, a), cdb = orient2d(c, d, b);
    if (abc != abd && cda != cdb && abc * abd != Sign::Positive && cda * cdb != Sign::Positive) return true;
    return (abc == Sign::Zero && isOnSegment(a, b, c)) || (abd == Sign::Zero && isOnSegment(a, b, d)) ||
           (cda == Sign::Zero && isOnSegment(c, d, a)) || (cdb == Sign::Zero && isOnSegment(c, d, b));
}

bool isInTriangle(Vec2 p, const std::array<Vec2, 3>& t)
{
    bool hasPositive = false, hasNegative = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const Sign side = orient2d(t[i], t[(i + 1) % 3], p);
        hasPositive = hasPositive || side == Sign::Positive;
        hasNegative = hasNegative || side == Sign::Negative;
    }
    return !(hasPositive && hasNegative);
}

bool doesCoplanarSegmentMeet(const Vec3& p, const Vec3& q, const TrianglePoints& t)
{
    const int axis = projectionAxis(t);
    const std::array<Vec2, 3> corners{flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)};
    const Vec2 a = flat(p, axis), b = flat(q, axis);
    if (isInTriangle(a, corners) || isInTriangle(b, corners)) return true;
    for (std::size_t i = 0; i < 3; ++i) {
        if (doSegmentsMeet(a, b, corners[i], corners[(i + 1) % 3])) return true;
    }
    return false;
}

}  // namespace

bool doesSegmentMeetTriangle(const Vec3& p, const Vec3& q, const TrianglePoints& t)
{
    const Sign above = orient3d(t[0], t[1], t[2], p), below = orient3d(t[0], t[1], t[2], q);
    if (above * below == Sign::Positive) return false;
    if (above == Sign::Zero && below == Sign::Zero) return doesCoplanarSegmentMeet(p, q, t);
    bool hasPositive = false, hasNegative = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const Sign side = orient3d(p, q, t[i], t[(i + 1) % 3]);
        hasPositive = hasPositive || side == Sign::Positive;
        hasNegative = hasNegative || side == Sign::Negative;
    }
    return !(hasPositive && hasNegative);
}

bool doTrianglesMeet(const TrianglePoints& a, const TrianglePoints& b)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (doesSegmentMeetTriangle(a[i], a[(i + 1) % 3], b)) return true;
        if (doesSegmentMeetTriangle(b[i], b[(i + 1) % 3], a)) return true;
    }
    return false;
}

bool doTrianglesMeetBeyondCorner(const TrianglePoints& a, const TrianglePoints& b)
{
    return doesSegmentMeetTriangle(a[1], a[2], b) || doesSegmentMeetTriangle(b[1], b[2], a);
}

bool doTrianglesOverlapAtEdge(const TrianglePoints& a, const TrianglePoints& b)
{
    if (orient3d(a[0], a[1], a[2], b[2]) != Sign::Zero) return false;
    const int axis = projectionAxis(a);
    const Vec2 u = flat(a[0], axis), v = flat(a[1], axis);
    return orient2d(u, v, flat(a[2], axis)) == orient2d(u, v, flat(b[2], axis));
}

}  // namespace mesher
