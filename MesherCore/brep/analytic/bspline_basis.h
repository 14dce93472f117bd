#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace mesher {

/// Highest degree of a spline; what CAD kernels allow.
inline constexpr std::size_t kHighestDegree = 25;

/// The basis functions that do not vanish at a parameter, with first and second derivatives: those of the poles
/// first … first + degree.
struct BSplineBasis
{
    std::size_t first = 0;
    std::array<double, kHighestDegree + 1> value{};
    std::array<double, kHighestDegree + 1> d1{};
    std::array<double, kHighestDegree + 1> d2{};
};

/// Requires     a flat knot vector that does not descend, t clamped into its valid range
/// Reference    [piegl1997] §2.5, the triangle of Cox and de Boor; the derivatives by differences of lower degrees
[[nodiscard]] BSplineBasis evaluateBasis(std::span<const double> knots, std::size_t degree, double t);

/// Index i of the last knot with knots[i] <= t < knots[i + 1], the last non-empty span at the upper end.
[[nodiscard]] std::size_t findSpan(std::span<const double> knots, std::size_t degree, double t);

/// Distinct knots strictly inside of the valid range whose multiplicity is at least `multiplicity`.
[[nodiscard]] std::vector<double> interiorKnots(std::span<const double> knots, std::size_t degree,
                                                std::size_t multiplicity);

}  // namespace mesher
