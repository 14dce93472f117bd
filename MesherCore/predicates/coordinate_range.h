#pragma once

#include "base/box.h"
#include "base/result.h"
#include "base/vec.h"

#include <cstddef>
#include <span>

namespace mesher {

/// The exact range: coordinates that are multiples of 2^kGridExponent and of magnitude at most
/// 2^kLargestExponent. There no sum, product or expansion of the predicates overflows, and products of up to
/// five coordinates or differences are multiples of 2^-1000, so that none underflows either. Proof:
/// docs/algorithms/predicates.md.
inline constexpr int kGridExponent = -200;
inline constexpr int kLargestExponent = 200;

/// False also for NaN and infinities.
[[nodiscard]] bool isInExactRange(const Vec2& p);
[[nodiscard]] bool isInExactRange(const Vec3& p);

/// One power of two that takes a model into the exact range. It never translates, because that would round.
///
/// Guarantees  the largest coordinate of the box gets a magnitude in [2^99, 2^100), which leaves room for
///             points constructed outside of the box and for squared volumes; a box of the origin alone or an
///             empty one is not scaled. Scaling is exact but for coordinates that are not multiples of 2^-200
///             then, that is, with bits more than 300 binary places below the largest: these are rounded and
///             counted.
/// Requires    finite coordinates, else ErrorCode::NonFinitePoint
class PowerOfTwoScaling
{
public:
    /// The largest coordinate is scaled to below 2^kKernelExponent.
    static constexpr int kKernelExponent = 100;

    [[nodiscard]] static Result<PowerOfTwoScaling> forBox(const Box2& box);
    [[nodiscard]] static Result<PowerOfTwoScaling> forBox(const Box3& box);
    /// Names the first point that is not finite.
    [[nodiscard]] static Result<PowerOfTwoScaling> forPoints(std::span<const Vec2> points);
    [[nodiscard]] static Result<PowerOfTwoScaling> forPoints(std::span<const Vec3> points);

    /// Adds the number of coordinates that had to be rounded to `roundedCoordinates`.
    [[nodiscard]] Vec2 toKernel(const Vec2& p, std::size_t& roundedCoordinates) const;
    [[nodiscard]] Vec3 toKernel(const Vec3& p, std::size_t& roundedCoordinates) const;
    /// Exact unless the model coordinate is subnormal or beyond the largest double.
    [[nodiscard]] Vec2 toModel(const Vec2& p) const;
    [[nodiscard]] Vec3 toModel(const Vec3& p) const;

    /// Kernel coordinates are model coordinates times two to this power.
    [[nodiscard]] int exponent() const { return exponent_; }

private:
    explicit PowerOfTwoScaling(double largestMagnitude);

    int exponent_ = 0;
};

}  // namespace mesher
