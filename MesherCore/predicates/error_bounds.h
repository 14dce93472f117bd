#pragma once

#include <limits>

/// Constants of the floating-point filters, in units of the roundoff 2^-53.
///
/// Let X, Y, Z be the largest magnitudes of the *computed* coordinate differences of a call, per axis, and W
/// the largest magnitude of a computed lift. A determinant whose computed magnitude exceeds
/// `constant * product of the maxima` has the right sign. Derivation: docs/algorithms/predicates.md; the
/// sums of first order found there are 8, 46, 40 and 376, and the constants here exceed them by more than one
/// unit, which covers all terms of second order and the at most five roundings of the bound itself.
///
/// Inside the exact range (coordinate_range.h) no operation overflows and no product underflows, so that the
/// relative error of each operation is at most one roundoff. The one product that may become subnormal is the
/// bound itself; docs/algorithms/predicates.md shows why that is harmless.
namespace mesher::detail {

#ifdef __FAST_MATH__
#error "the predicates are exact only without -ffast-math"
#endif
static_assert(std::numeric_limits<double>::is_iec559, "the predicates need IEEE 754 binary64");

inline constexpr double kRoundoff = 0x1p-53;

/// Times X * Y.
inline constexpr double kOrient2dBound = 10.0 * kRoundoff;
/// Times X * Y * Z.
inline constexpr double kOrient3dBound = 48.0 * kRoundoff;
/// Times X * Y * W, where W = X^2 + Y^2.
inline constexpr double kIncircleBound = 42.0 * kRoundoff;
/// Times X * Y * Z * W, where W is the largest squared distance to the last point.
inline constexpr double kInsphereBound = 380.0 * kRoundoff;

}  // namespace mesher::detail
