#pragma once

#include "brep/brep_model.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mesher {

/// The ends of the panels along u in which a face is integrated: where its surface is not analytic, and some between.
[[nodiscard]] std::vector<double> panelEnds(const BrepFace& face, int panels);

/// Steps in which a coedge of a face is integrated, an even number: enough for the spans of its edge and of the surface along v.
[[nodiscard]] std::size_t integrationSteps(const BrepModel& model, const BrepFace& face,
                                           const BrepCoedge& coedge);

/// Integral over a line of equal v from the first end of a panel to a point of a density of its points (per du dv), by Gauss'
/// rule of four points in each panel.
template <class Density>
auto stripIntegral(const Surface& surface, const std::vector<double>& ends, Vec2 end, Density density)
{
    constexpr std::array<double, 4> kAbscissae{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                               0.8611363115940526};
    constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                             0.3478548451374538};
    decltype(density(SurfacePoint())) sum{};
    for (std::size_t panel = 0; panel + 1 < ends.size(); ++panel) {
        const double left = ends[panel];
        // Rounding may put the point before the first end or beyond the last.
        const bool isLast = panel + 2 == ends.size() || end.x <= ends[panel + 1];
        const double right = isLast ? end.x : ends[panel + 1];
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec2 uv{left + 0.5 * (1.0 + kAbscissae[k]) * (right - left), end.y};
            sum = sum + (0.5 * kWeights[k] * (right - left)) * density(surface.evaluate(uv));
        }
        if (isLast) break;
    }
    return sum;
}

/// Integral over a face of a density per du dv, from its loops by Green's theorem in the parameters: each coedge's share is the
/// integral along it of (integral of the density from the left border to u) dv, by trapezia of two widths, extrapolated.
template <class Density>
auto faceIntegral(const BrepModel& model, const BrepFace& face, int panels, Density density)
{
    using Value = decltype(density(SurfacePoint()));
    const std::vector<double> ends = panelEnds(face, panels);
    Value total{};
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const Interval part = model.edges[coedge.edge].part;
            const std::size_t steps = integrationSteps(model, face, coedge);
            std::vector<double> v(steps + 1);
            std::vector<Value> strip(steps + 1);
            for (std::size_t i = 0; i <= steps; ++i) {
                const double share = static_cast<double>(i) / static_cast<double>(steps);
                const Vec2 uv = coedge.parameterCurve->position(part.at(share));
                v[i] = uv.y;
                strip[i] = stripIntegral(*face.surface, ends, uv, density);
            }
            const auto sumOf = [&](std::size_t step) {
                Value sum{};
                for (std::size_t i = step; i <= steps; i += step)
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
