#include "brep/chebyshev_series.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {

namespace {

constexpr std::size_t kCount = ChebyshevSeries::kSampleCount;

/// cos(j pi (k + 1/2) / n), the value of T_j at the k-th abscissa.
struct CosineTable
{
    std::array<std::array<double, kCount>, kCount> values{};

    CosineTable()
    {
        for (std::size_t j = 0; j < kCount; ++j) {
            for (std::size_t k = 0; k < kCount; ++k) {
                const double angle = static_cast<double>(j) * (static_cast<double>(k) + 0.5);
                values[j][k] = std::cos(angle * std::numbers::pi / static_cast<double>(kCount));
            }
        }
    }
};

const CosineTable& cosines()
{
    static const CosineTable table;
    return table;
}

}  // namespace

const std::array<double, kCount>& ChebyshevSeries::sampleAbscissae()
{
    return cosines().values[1];
}

ChebyshevSeries ChebyshevSeries::fitted(const std::array<double, kSampleCount>& samples)
{
    ChebyshevSeries series;
    for (std::size_t j = 0; j < kCount; ++j) {
        double sum = 0.0;
        for (std::size_t k = 0; k < kCount; ++k) sum += samples[k] * cosines().values[j][k];
        series.coefficients[j] = sum * (j == 0 ? 1.0 : 2.0) / static_cast<double>(kCount);
    }
    return series;
}

double ChebyshevSeries::at(double x) const
{
    // Clenshaw's recurrence.
    double next = 0.0, afterNext = 0.0;
    for (std::size_t j = coefficients.size() - 1; j > 0; --j) {
        const double current = coefficients[j] + 2.0 * x * next - afterNext;
        afterNext = next;
        next = current;
    }
    return coefficients[0] + x * next - afterNext;
}

ChebyshevSeries ChebyshevSeries::primitive() const
{
    ChebyshevSeries result;
    const auto coefficient = [this](std::size_t j) { return j < kCount ? coefficients[j] : 0.0; };
    double valueAtLowerEnd = 0.0;
    for (std::size_t j = 1; j <= kCount; ++j) {
        const double lower = j == 1 ? 2.0 * coefficient(0) : coefficient(j - 1);
        result.coefficients[j] = (lower - coefficient(j + 1)) / (2.0 * static_cast<double>(j));
        valueAtLowerEnd += (j % 2 == 0 ? 1.0 : -1.0) * result.coefficients[j];
    }
    result.coefficients[0] = -valueAtLowerEnd;
    return result;
}

double ChebyshevSeries::tail() const
{
    return std::max({std::abs(coefficients[kCount - 1]), std::abs(coefficients[kCount - 2]),
                     std::abs(coefficients[kCount - 3])});
}

}  // namespace mesher
