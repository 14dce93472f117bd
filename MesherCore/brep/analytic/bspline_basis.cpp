#include "brep/analytic/bspline_basis.h"

#include "base/assert.h"

#include <algorithm>

namespace mesher {

namespace {

using Row = std::array<double, kHighestDegree + 1>;

/// Basis functions of one degree from those of the degree below, in place; row[0 … degree].
void raiseDegree(std::span<const double> knots, std::size_t span, std::size_t degree, double t, Row& row)
{
    double carried = 0.0;
    for (std::size_t r = 0; r < degree; ++r) {
        const double right = knots[span + r + 1];
        const double left = knots[span + r + 1 - degree];
        const double share = row[r] / (right - left);
        row[r] = carried + (right - t) * share;
        carried = (t - left) * share;
    }
    row[degree] = carried;
}

/// Derivatives of the functions of `degree` from values (or derivatives) of those one degree lower.
Row differentiate(std::span<const double> knots, std::size_t span, std::size_t degree, const Row& lower)
{
    Row result{};
    double carried = 0.0;
    for (std::size_t r = 0; r < degree; ++r) {
        const double share =
            static_cast<double>(degree) * lower[r] / (knots[span + r + 1] - knots[span + r + 1 - degree]);
        result[r] = carried - share;
        carried = share;
    }
    result[degree] = carried;
    return result;
}

}  // namespace

std::size_t findSpan(std::span<const double> knots, std::size_t degree, double t)
{
    const std::size_t last = knots.size() - degree - 2;
    const auto begin = knots.begin() + static_cast<std::ptrdiff_t>(degree) + 1;
    const auto end = knots.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    auto span = static_cast<std::size_t>(std::upper_bound(begin, end, t) - knots.begin()) - 1;
    while (span > degree && knots[span] == knots[span + 1]) --span;
    return span;
}

BSplineBasis evaluateBasis(std::span<const double> knots, std::size_t degree, double t)
{
    MESHER_PRECONDITION(1 <= degree && degree <= kHighestDegree);
    const std::size_t span = findSpan(knots, degree, t);
    BSplineBasis basis;
    basis.first = span - degree;
    Row row{};
    row[0] = 1.0;
    for (std::size_t d = 1; d <= degree; ++d) {
        if (d + 1 == degree) basis.d2 = differentiate(knots, span, d, row);
        if (d == degree) {
            basis.d1 = differentiate(knots, span, d, row);
            basis.d2 = degree > 1 ? differentiate(knots, span, d, basis.d2) : Row{};
        }
        raiseDegree(knots, span, d, t, row);
    }
    basis.value = row;
    return basis;
}

std::vector<double> interiorKnots(std::span<const double> knots, std::size_t degree, std::size_t multiplicity)
{
    std::vector<double> result;
    const std::size_t end = knots.size() - degree - 1;
    for (std::size_t i = degree + 1; i < end;) {
        std::size_t j = i;
        while (j < end && knots[j] == knots[i]) ++j;
        if (knots[i] > knots[degree] && knots[i] < knots[end] && j - i >= multiplicity) result.push_back(knots[i]);
        i = j;
    }
    return result;
}

}  // namespace mesher
