#include "brep/face_area.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace mesher {

namespace {

/// Integral of |du x dv| along a line of equal v.
double stripArea(const Surface& surface, double left, Vec2 end)
{
    // Gauss' rule of four points in each of two panels.
    constexpr std::array<double, 4> kAbscissae{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                               0.8611363115940526};
    constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                             0.3478548451374538};
    double sum = 0.0;
    for (const double panel : {0.25, 0.75}) {
        for (std::size_t k = 0; k < 4; ++k) {
            const double share = panel + 0.25 * kAbscissae[k];
            const Vec2 uv{left + share * (end.x - left), end.y};
            sum += 0.25 * kWeights[k] * length(surface.evaluate(uv).normal());
        }
    }
    return sum * (end.x - left);
}

/// The coedge's share is the integral along it of (integral of |du x dv| from the left border to u) dv; trapezia of two
/// widths, extrapolated.
double areaBeside(const BrepModel& model, const BrepFace& face, const BrepCoedge& coedge)
{
    constexpr std::size_t kSteps = 64;
    const Interval part = model.edges[coedge.edge].part;
    std::array<double, kSteps + 1> v{}, strip{};
    for (std::size_t i = 0; i <= kSteps; ++i) {
        const Vec2 uv = coedge.parameterCurve->position(part.at(static_cast<double>(i) / kSteps));
        v[i] = uv.y;
        strip[i] = stripArea(*face.surface, face.boundsU.first, uv);
    }
    const auto sumOf = [&](std::size_t step) {
        double sum = 0.0;
        for (std::size_t i = step; i <= kSteps; i += step)
            sum += 0.5 * (v[i] - v[i - step]) * (strip[i] + strip[i - step]);
        return sum;
    };
    const double sum = (4.0 * sumOf(1) - sumOf(2)) / 3.0;
    return coedge.isReversed ? -sum : sum;
}

}  // namespace

double areaOf(const BrepModel& model, const BrepFace& face)
{
    double area = 0.0;
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) area += areaBeside(model, face, coedge);
    }
    return std::abs(area);
}

}  // namespace mesher
