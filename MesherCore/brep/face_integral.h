#pragma once

#include "brep/brep_model.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mesher {

/// The ends of the panels along u in which a face is integrated: where its surface is not analytic, and some between.
[[nodiscard]] std::vector<double> panelEnds(const BrepFace& face);

/// Parameters of the face along a coedge, evenly spaced and an odd number: enough for the spans of its edge and of the surface
/// along v. None where v stays the same, since nothing is integrated there.
[[nodiscard]] std::vector<Vec2> placesAlong(const BrepModel& model, const BrepFace& face,
                                            const BrepCoedge& coedge);

/// Integral of a density of points of a surface (per du dv) along a line of equal v, by Gauss' rule of four points; a density of
/// a plane is the same everywhere.
template <class Density>
auto panelIntegral(const Surface& surface, double left, Vec2 right, Density density)
{
    constexpr std::array<double, 4> kAbscissae{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                               0.8611363115940526};
    constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                             0.3478548451374538};
    const double width = right.x - left;
    if (surface.kind() == SurfaceKind::Plane) return width * density(surface.evaluate(right));
    decltype(density(SurfacePoint())) sum{};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 uv{left + 0.5 * (1.0 + kAbscissae[k]) * width, right.y};
        sum = sum + (0.5 * kWeights[k] * width) * density(surface.evaluate(uv));
    }
    return sum;
}

/// Integrals over the lines of equal v from the first end of a panel to the places. Panel by panel, since surfaces that keep the
/// last span they were asked for are slow when spans take turns.
template <class Density>
auto stripIntegrals(const Surface& surface, const std::vector<double>& ends, const std::vector<Vec2>& places,
                    Density density)
{
    std::vector<decltype(density(SurfacePoint()))> strips(places.size());
    for (std::size_t panel = 0; panel + 1 < ends.size(); ++panel) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Vec2& place = places[i];
            if (panel > 0 && place.x <= ends[panel]) continue;
            // Rounding may put the place before the first end or beyond the last.
            const bool isLast = panel + 2 == ends.size() || place.x <= ends[panel + 1];
            const Vec2 right{isLast ? place.x : ends[panel + 1], place.y};
            strips[i] = strips[i] + panelIntegral(surface, ends[panel], right, density);
        }
    }
    return strips;
}

/// Integral over a face of a density per du dv, from its loops by Green's theorem in the parameters: each coedge's share is the
/// integral along it of (integral of the density from the left border to u) dv, by trapezia of two widths, extrapolated.
template <class Density>
auto faceIntegral(const BrepModel& model, const BrepFace& face, Density density)
{
    using Value = decltype(density(SurfacePoint()));
    const std::vector<double> ends = panelEnds(face);
    Value total{};
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const std::vector<Vec2> places = placesAlong(model, face, coedge);
            const std::vector<Value> strips = stripIntegrals(*face.surface, ends, places, density);
            const auto sumOf = [&](std::size_t step) {
                Value sum{};
                for (std::size_t i = step; i < places.size(); i += step)
                    sum = sum + 0.5 * (places[i].y - places[i - step].y) * (strips[i] + strips[i - step]);
                return sum;
            };
            const double sign = coedge.isReversed ? -1.0 : 1.0;
            total = total + (sign / 3.0) * (4.0 * sumOf(1) + -1.0 * sumOf(2));
        }
    }
    return total;
}

}  // namespace mesher
