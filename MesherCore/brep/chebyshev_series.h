#pragma once

#include <array>
#include <cstddef>

namespace mesher {

/// A function on [-1, 1] as the sum of c[j] T_j(x).
struct ChebyshevSeries
{
    static constexpr std::size_t kSampleCount = 16;

    std::array<double, kSampleCount + 1> coefficients{};

    /// The abscissae, descending and without the ends, at which `fitted` wants its samples.
    [[nodiscard]] static const std::array<double, kSampleCount>& sampleAbscissae();
    /// The interpolant of degree 15 of the samples.
    [[nodiscard]] static ChebyshevSeries fitted(const std::array<double, kSampleCount>& samples);

    [[nodiscard]] double at(double x) const;
    /// The primitive that is zero at -1; of an interpolant, so that it fits in the coefficients.
    [[nodiscard]] ChebyshevSeries primitive() const;
    /// Size of the coefficients that would go on if the samples were too few.
    [[nodiscard]] double tail() const;
};

}  // namespace mesher
