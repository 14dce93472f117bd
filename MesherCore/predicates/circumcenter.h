#pragma once

#include "base/vec.h"

#include <optional>

/// Centres of circumscribed circles and spheres in plain double arithmetic: constructions, not predicates.
///
/// Guarantees  computed relative to one vertex, hence accurate for small elements far from the origin; the
///             error relative to the radius is about the roundoff over the sine of the smallest angle
///             (triangles), or over the element's volume in units of its cubed longest edge (tetrahedra).
///             Nothing exact may be concluded from a centre: round it, then ask the predicates.
/// Requires    points in the exact range (coordinate_range.h)
/// Returns     nothing if the element is so flat that its computed area or volume is zero
namespace mesher {

[[nodiscard]] std::optional<Vec2> approximateCircumcenter(const Vec2& a, const Vec2& b, const Vec2& c);
/// In the plane of the triangle.
[[nodiscard]] std::optional<Vec3> approximateCircumcenter(const Vec3& a, const Vec3& b, const Vec3& c);
[[nodiscard]] std::optional<Vec3> approximateCircumcenter(const Vec3& a, const Vec3& b, const Vec3& c,
                                                          const Vec3& d);

}  // namespace mesher
