#include "predicates/static_filter.h"

#include "predicates/error_bounds.h"

namespace mesher {

// The computed difference of two coordinates of the box is at most the computed extent, because rounding is
// monotone; the maxima of error_bounds.h are therefore bounded by the extents and by sums of their squares.

StaticFilter2d StaticFilter2d::forBox(const Box2& box)
{
    if (box.isEmpty()) return {};
    const Vec2 extent = box.extent();
    const double area = extent.x * extent.y;
    const double lift = squaredLength(extent);
    return {detail::kOrient2dBound * area, detail::kIncircleBound * area * lift};
}

StaticFilter3d StaticFilter3d::forBox(const Box3& box)
{
    if (box.isEmpty()) return {};
    const Vec3 extent = box.extent();
    const double volume = extent.x * extent.y * extent.z;
    const double lift = squaredLength(extent);
    return {detail::kOrient3dBound * volume, detail::kInsphereBound * volume * lift};
}

}  // namespace mesher
