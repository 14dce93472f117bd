#pragma once

#include "brep/brep_model.h"

#include <array>
#include <cstddef>

namespace mesher {

/// Integral over a line of equal v of a density of its points (per du dv), by Gauss' rule of four points in each panel.
template <class Density>
auto stripIntegral(const Surface& surface, double left, Vec2 end, int panels, Density density)
{
    constexpr std::array<double, 4> kAbscissae{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                               0.8611363115940526};
    constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                             0.3478548451374538};
    const double half = 0.5 / panels;
    decltype(density(SurfacePoint())) sum{};
    for (int panel = 0; panel < panels; ++panel) {
        for (std::size_t k = 0; k < 4; ++k) {
            const double share = half * (2.0 * panel + 1.0 + kAbscissae[k]);
            const Vec2 uv{left + share * (end.x - left), end.y};
            sum = sum + (half * kWeights[k] * (end.x - left)) * density(surface.evaluate(uv));
        }
    }
    return sum;
}

/// Integral over a face of a density per du dv, from its loops by Green's theorem in the parameters: each coedge's share is the
/// integral along it of (integral of the density from the left border to u) dv, by trapezia of two widths, extrapolated.
template <class Density>
auto faceIntegral(const BrepModel& model, const BrepFace& face, int panels, Density density)
{
    using Value = decltype(density(SurfacePoint()));
    constexpr std::size_t kSteps = 64;
    Value total{};
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const Interval part = model.edges[coedge.edge].part;
            std::array<double, kSteps + 1> v{};
            std::array<Value, kSteps + 1> strip{};
            for (std::size_t i = 0; i <= kSteps; ++i) {
                const Vec2 uv = coedge.parameterCurve->position(part.at(static_cast<double>(i) / kSteps));
                v[i] = uv.y;
                strip[i] = stripIntegral(*face.surface, face.boundsU.first, uv, panels, density);
            }
            const auto sumOf = [&](std::size_t step) {
                Value sum{};
                for (std::size_t i = step; i <= kSteps; i += step)
                    sum = sum + 0.5 * (v[i] - v[i - step]) * (strip[i] + strip[i - step]);
                return sum;
            };
            const double sign = coedge.isReversed ? -1.0 : 1.0;
            total = total + (sign / 3.0) * (4.0 * sumOf(1) + -1.0 * sumOf(2));
        }
    }
    return total;
}

}  // namespace mesher
