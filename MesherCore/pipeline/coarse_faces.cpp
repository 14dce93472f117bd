#include "pipeline/coarse_faces.h"

#include "pipeline/facet_departures.h"
#include "surface_sampling/sample_surface.h"

#include <algorithm>
#include <chrono>
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

SurfaceSamplingOptions coarseOptions(double sag, std::optional<double> seconds)
{
    SurfaceSamplingOptions options;
    options.curves.maxVariation = 90.0;
    options.curves.maxSag = sag;
    options.facets.maxSag = sag;
    options.facets.minAngle = 0.0;
    options.facets.leastCurvatureSize = sag;
    options.maxCertificateRounds = -1;
    if (seconds) {
        options.limits.maxTime = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
            std::chrono::duration<double>(std::min(*seconds, 1e9)));
    }
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
    return settings;
}

Result<std::vector<CoarseFacet>> coarseFaces(const ModelComponent& part, double sag,
                                             std::optional<double> seconds, RunContext& context)
{
    RunContext own(sizesSettings(context));
    const Result<SurfaceSample> sample = sampleSurface(part.model, coarseOptions(sag, seconds), own);
    if (!sample) return named(sample.error(), part);
    if (!sample->failures.empty()) return named(sample->failures.front().second, part);
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
