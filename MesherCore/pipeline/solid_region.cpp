#include "pipeline/solid_region.h"

#include "base/box.h"

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace mesher {

namespace {

/// Rays go up along a direction that parts hardly have faces or edges along; space is sheared to make it the z axis.
Vec3 sheared(const Vec3& p) { return {p.x - 0.318309886 * p.z, p.y - 0.141421356 * p.z, p.z}; }

std::vector<std::array<Vec3, 3>> shearedAll(std::vector<std::array<Vec3, 3>> triangles)
{
    for (auto& triangle : triangles) {
        for (Vec3& corner : triangle) corner = sheared(corner);
    }
    return triangles;
}

BoxTree treeOf(const std::vector<std::array<Vec3, 3>>& triangles)
{
    std::vector<Box3> boxes;
    boxes.reserve(triangles.size());
    for (const auto& triangle : triangles) boxes.push_back(Box3::of(triangle));
    return BoxTree(boxes);
}

/// Whether a ray in the plane of x and y, along x, crosses the edge. Both triangles beside an edge get the same answer.
bool isLeftOf(const Vec3& p, Vec3 a, Vec3 b)
{
    if ((a.y <= p.y) == (b.y <= p.y)) return false;
    if (std::tie(b.x, b.y) < std::tie(a.x, a.y)) std::swap(a, b);
    return p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
}

bool isBelow(const Vec3& p, const std::array<Vec3, 3>& corner)
{
    bool isWithin = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (isLeftOf(p, corner[i], corner[(i + 1) % 3])) isWithin = !isWithin;
    }
    if (!isWithin) return false;
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    return dot(corner[0] - p, normal) * normal.z > 0.0;
}

}  // namespace

SolidRegion::SolidRegion(std::vector<std::array<Vec3, 3>> triangles)
    : triangles_(shearedAll(std::move(triangles))), tree_(treeOf(triangles_))
{
    std::vector<std::array<Vec3, 3>> ordered;
    ordered.reserve(triangles_.size());
    for (const std::uint32_t i : tree_.order()) ordered.push_back(triangles_[i]);
    triangles_ = std::move(ordered);
}

bool SolidRegion::contains(const Vec3& point) const
{
    const Vec3 p = sheared(point);
    bool isInside = false;
    // The search is one for the smallest value; a constant one makes it visit all nodes that are not ruled out.
    constexpr double kVisit = 0.0, kRuledOut = 2.0, kNone = 1.0;
    const auto boundOf = [&](std::uint32_t node) {
        const Box3& box = tree_.nodes()[node].box;
        const bool isAbove = box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y &&
                             p.z <= box.high.z;
        return isAbove ? kVisit : kRuledOut;
    };
    const auto look = [&](std::uint32_t i) {
        if (isBelow(p, triangles_[i])) isInside = !isInside;
        return kNone;
    };
    tree_.searchSmallest(boundOf, look, kNone);
    return isInside;
}

}  // namespace mesher
