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

/// The middle of a segment and that of its curve.
struct SegmentMiddle
{
    Vec3 chord;
    Vec3 curve;
};

/// By the nodes of the segment.
IndexedMap<std::uint64_t, SegmentMiddle> segmentMiddles(const BrepModel& model, const SurfaceMesh& mesh)
{
    IndexedMap<std::uint64_t, SegmentMiddle> middles;
    for (const SurfaceSegment& segment : mesh.segments) {
        if (!segment.isAlive() || model.edges[segment.edge].isDegenerate) continue;
        const auto& [a, b] = segment.node;
        const Vec3 chord = 0.5 * (mesh.nodes[a].position + mesh.nodes[b].position);
        const auto& [from, to] = segment.parameter;
        middles.insert(keyOf(a, b), {chord, model.edges[segment.edge].curve->position(0.5 * (from + to))});
    }
    return middles;
}

FacetDeparture departureOf(const BrepModel& model, const SurfaceMesh& mesh, const SurfaceFacet& facet,
                           const IndexedMap<std::uint64_t, SegmentMiddle>& middles)
{
    const BrepFace& face = model.faces[facet.face];
    const auto& uv = facet.parameters;
    Vec3 middle;
    for (const NodeId node : facet.node) middle = middle + (1.0 / 3.0) * mesh.nodes[node].position;
    FacetDeparture departure;
    departure.distance = face.surface->project(middle, (1.0 / 3.0) * (uv[0] + uv[1] + uv[2])).distance;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const SegmentMiddle* known = middles.find(keyOf(facet.node[i], facet.node[j]));
        if (known == nullptr) continue;
        departure.distance = std::max(departure.distance, length(known->chord - known->curve));
        const Vec3 between = face.surface->position(0.5 * (uv[i] + uv[j]));
        departure.isFlush = departure.isFlush && length(between - known->curve) <= face.tolerance;
    }
    return departure;
}

}  // namespace

IdVector<FacetId, FacetDeparture> facetDepartures(const BrepModel& model, const SurfaceMesh& mesh)
{
    const IndexedMap<std::uint64_t, SegmentMiddle> middles = segmentMiddles(model, mesh);
    IdVector<FacetId, FacetDeparture> departures(mesh.facets.size());
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const SurfaceFacet& facet = mesh.facets[FacetId(f)];
        if (facet.isAlive()) departures[FacetId(f)] = departureOf(model, mesh, facet, middles);
    }
    return departures;
}

}  // namespace mesher
