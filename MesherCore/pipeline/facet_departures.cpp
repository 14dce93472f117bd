#include "pipeline/facet_departures.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mesher {

namespace {

std::uint64_t keyOf(NodeId a, NodeId b)
{
    return std::uint64_t{std::min(a, b).value} << 32 | std::max(a, b).value;
}

/// By the nodes of the segment.
IndexedMap<std::uint64_t, double> segmentDepartures(const BrepModel& model, const SurfaceMesh& mesh)
{
    IndexedMap<std::uint64_t, double> departures;
    for (const SurfaceSegment& segment : mesh.segments) {
        if (!segment.isAlive() || model.edges[segment.edge].isDegenerate) continue;
        const auto& [a, b] = segment.node;
        const Vec3 chord = 0.5 * (mesh.nodes[a].position + mesh.nodes[b].position);
        const auto& [from, to] = segment.parameter;
        const Vec3 curve = model.edges[segment.edge].curve->position(0.5 * (from + to));
        departures.insert(keyOf(a, b), length(chord - curve));
    }
    return departures;
}

}  // namespace

IdVector<FacetId, double> facetDepartures(const BrepModel& model, const SurfaceMesh& mesh)
{
    const IndexedMap<std::uint64_t, double> ofSegments = segmentDepartures(model, mesh);
    IdVector<FacetId, double> departures(mesh.facets.size(), 0.0);
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const SurfaceFacet& facet = mesh.facets[FacetId(f)];
        if (!facet.isAlive()) continue;
        Vec3 middle;
        for (const NodeId node : facet.node) middle = middle + (1.0 / 3.0) * mesh.nodes[node].position;
        const auto& uv = facet.parameters;
        const Vec2 parameters = (1.0 / 3.0) * (uv[0] + uv[1] + uv[2]);
        double& departure = departures[FacetId(f)];
        departure = model.faces[facet.face].surface->project(middle, parameters).distance;
        for (std::size_t i = 0; i < 3; ++i) {
            const double* known = ofSegments.find(keyOf(facet.node[i], facet.node[(i + 1) % 3]));
            if (known != nullptr) departure = std::max(departure, *known);
        }
    }
    return departures;
}

}  // namespace mesher
