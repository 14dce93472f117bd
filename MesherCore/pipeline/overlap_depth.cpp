#include "pipeline/overlap_depth.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mesher {

namespace {

constexpr std::size_t kMostFacets = 1000;

struct DepthIntegral
{
    double area = 0.0;
    double volume = 0.0;
};

using Corners = std::array<Vec3, 3>;

Corners cornersOf(const ComponentSurface& surface, FacetId facet)
{
    const auto& node = surface.mesh().facets[facet].node;
    return {surface.mesh().nodes[node[0]].position, surface.mesh().nodes[node[1]].position,
            surface.mesh().nodes[node[2]].position};
}

Vec3 middleOf(const Corners& p) { return (1.0 / 3.0) * (p[0] + p[1] + p[2]); }

/// Of the surface's faces in the other group, a point for each facet.
DepthIntegral integrate(const ComponentSurface& surface, const ComponentSurface& other, double tolerance)
{
    std::vector<FacetId> facets;
    for (std::uint32_t i = 0; i < surface.mesh().facets.size(); ++i) {
        const FacetId facet(i);
        if (surface.mesh().facets[facet].isAlive() &&
            other.box().contains(middleOf(cornersOf(surface, facet))))
            facets.push_back(facet);
    }
    const std::size_t stride = facets.size() / kMostFacets + 1;
    DepthIntegral integral;
    for (std::size_t i = 0; i < facets.size(); i += stride) {
        const Corners p = cornersOf(surface, facets[i]);
        const auto& at = surface.mesh().facets[facets[i]].parameters;
        const auto exact = surface.onFace(facets[i], middleOf(p), (1.0 / 3.0) * (at[0] + at[1] + at[2]));
        if (!exact) continue;
        const ComponentSurface::Position position = other.positionOf(exact->position, tolerance);
        if (position.kind != ComponentSurface::Position::Kind::Inside) continue;
        const double area = 0.5 * static_cast<double>(stride) * length(cross(p[1] - p[0], p[2] - p[0]));
        integral.area += area;
        integral.volume += area * position.depth;
    }
    return integral;
}

}  // namespace

std::optional<double> shallowCommonVolume(const ComponentSurface& first, const ComponentSurface& second,
                                          double tolerance)
{
    const DepthIntegral a = integrate(first, second, tolerance);
    const DepthIntegral b = integrate(second, first, tolerance);
    const double area = a.area + b.area;
    const double sag = first.largestSag() + second.largestSag();
    if (!(area > 0.0) || a.volume + b.volume > sag * area) return std::nullopt;
    // Each of the two sides of a thin layer tells its volume, if it has a point in it.
    const double sides = (a.area > 0.0 ? 1.0 : 0.0) + (b.area > 0.0 ? 1.0 : 0.0);
    return (a.volume + b.volume) / sides;
}

}  // namespace mesher
