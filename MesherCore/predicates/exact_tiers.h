#pragma once

#include "base/vec.h"
#include "predicates/sign.h"

#include <optional>

/// The exact tiers behind the floating-point filters, each callable alone so that tests can compare them.
///
/// Short          the plain double determinant, if the coordinates are so short that nothing in it was
///                rounded.
/// Integer tiers  the coordinates as multiples of one power of two, as 64- or 128-bit integers, and the
///                determinant in fixed-width integer arithmetic; nothing is returned if the coordinates do
///                not fit. Nearly every degenerate configuration of real models ends in the first of them.
/// Expansions     always decide, for coordinates of any exponents in the exact range.
namespace mesher::detail {

std::optional<Sign> orient2dShort(const Vec2& a, const Vec2& b, const Vec2& c);
std::optional<Sign> orient2dInteger64(const Vec2& a, const Vec2& b, const Vec2& c);
std::optional<Sign> orient2dInteger128(const Vec2& a, const Vec2& b, const Vec2& c);
Sign orient2dExpansion(const Vec2& a, const Vec2& b, const Vec2& c);

std::optional<Sign> incircleShort(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
std::optional<Sign> incircleInteger64(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
std::optional<Sign> incircleInteger128(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
Sign incircleExpansion(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

std::optional<Sign> orient3dShort(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
std::optional<Sign> orient3dInteger64(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
std::optional<Sign> orient3dInteger128(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
Sign orient3dExpansion(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

std::optional<Sign> insphereShort(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);
std::optional<Sign> insphereInteger64(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                      const Vec3& e);
std::optional<Sign> insphereInteger128(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                       const Vec3& e);
Sign insphereExpansion(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace mesher::detail
