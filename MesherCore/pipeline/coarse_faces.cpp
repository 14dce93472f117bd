#include "pipeline/coarse_faces.h"

#include "pipeline/facet_departures.h"
#include "surface_sampling/sample_surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace mesher {

namespace {

Error named(Error error, const ModelComponent& part)
{
    error.entity = part.inWhole(error.entity);
    error.message = part.inWhole(error.message);
    return error;
}

SurfaceSamplingOptions coarseOptions(double sag)
{
    SurfaceSamplingOptions options;
    options.curves.maxVariation = 90.0;
    options.curves.maxSag = sag;
    options.facets.maxSag = sag;
    options.facets.minAngle = 0.0;
    options.facets.leastCurvatureSize = sag;
    options.maxCertificateRounds = -1;
    return options;
}

}  // namespace

RunSettings sizesSettings(RunContext& context)
{
    RunSettings settings;
    settings.threads = context.threads();
    settings.seed = context.seed();
    settings.progress = [&context](std::string_view, double fraction) {
        return context.reportProgress("sizes", fraction);
    };
    settings.poll = [&context] { return context.stopReason() != StopReason::Cancelled; };
    return settings;
}

Result<std::vector<CoarseFacet>> coarseFaces(const ModelComponent& part, double sag, RunContext& context)
{
    RunContext own(sizesSettings(context));
    own.limitTimeAs(context);
    const Result<SurfaceSample> sample = sampleSurface(part.model, coarseOptions(sag), own);
    if (!sample) return named(sample.error(), part);
    if (!sample->failures.empty()) return named(sample->failures.front().second, part);
    if (!sample->surface) return std::vector<CoarseFacet>{};
    const SurfaceMesh& mesh = sample->surface->mesh();
    const IdVector<FacetId, FacetDeparture> departures = facetDepartures(part.model, mesh);
    std::vector<CoarseFacet> facets;
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const SurfaceFacet& facet = mesh.facets[FacetId(f)];
        if (!facet.isAlive()) continue;
        CoarseFacet& coarse = facets.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) coarse.corner[i] = mesh.nodes[facet.node[i]].position;
        coarse.departure = departures[FacetId(f)].distance;
    }
    return facets;
}

}  // namespace mesher
