#include "triangulation2d/triangulate_planar.h"

#include "triangulation2d/constrained_delaunay2d.h"
#include "triangulation2d/planar_estimate.h"

#include <chrono>
#include <string>
#include <utility>

namespace mesher {
namespace {

class Stopwatch
{
public:
    /// Seconds since the last call or the start.
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Result<void> checkRange(const char* name, double value, double low, double high)
{
    // Also refuses NaN.
    if (low <= value && value <= high) return {};
    Error error;
    error.code = ErrorCode::InvalidArgument;
    error.entity = std::string("option ") + name;
    error.message = "the value is out of range";
    error.remedy = "choose one from " + std::to_string(low) + " to " + std::to_string(high);
    return error;
}

Result<void> checkOptions(const PlanarOptions& options)
{
    constexpr double kSmallestTvDegrees = 30.0;
    constexpr double kLargestTvDegrees = 90.0;
    // Sixty degrees is asked of no triangulation; beyond 45 none of the input's own corners could be met.
    constexpr double kLargestMinAngle = 45.0;
    constexpr double kLargestFactor = 1e9;
    const PlanarSizing& sizing = options.refinement.sizing;
    if (auto r =
            checkRange("maxVariation", options.sampling.maxVariation, kSmallestTvDegrees, kLargestTvDegrees);
        !r) {
        return r;
    }
    if (auto r = checkRange("minAngle", options.refinement.minAngle, 0.0, kLargestMinAngle); !r) return r;
    if (auto r = checkRange("refinement", sizing.refinement, 1.0, kLargestFactor); !r) return r;
    return checkRange("grading", sizing.grading, 1.0 / kLargestFactor, kLargestFactor);
}

void countResult(PlanarResult& result)
{
    const PlanarTriangulation& t = result.triangulation;
    result.counts.triangles = 0;
    for (std::uint32_t i = 0; i < t.mesh().triangleSlots(); ++i) {
        if (t.mesh().isAlive(TriangleId(i)) && t.isMeshed(TriangleId(i))) ++result.counts.triangles;
    }
    result.counts.vertices = t.mesh().vertexCount();
    result.counts.boundaryEdges = t.boundary.aliveCount();
}

}  // namespace

Result<PlanarResult> triangulatePlanar(const PlanarCurveComplex& complex, const PlanarOptions& options,
                                       RunContext& context)
{
    if (auto checked = checkOptions(options); !checked) return checked.error();
    Stopwatch watch;
    PlanarResult result;
    PlanarTriangulation& triangulation = result.triangulation;
    Budget budget(options.limits, context);

    auto domain = PlanarDomain::make(complex);
    if (!domain) return domain.error();
    triangulation.scale = domain->scale();
    auto boundary = sampleCurves(*domain, options.sampling);
    if (!boundary) return boundary.error();
    triangulation.boundary = std::move(*boundary);
    result.counts.sampleVertices = triangulation.boundary.vertices.size();
    triangulation.smallAngles = protectSmallAngles(*domain, triangulation.boundary);
    result.counts.smallAngleSplits = triangulation.smallAngles.splits;
    result.seconds.sampling = watch.lap();

    auto enrichment = enrichBoundary(*domain, triangulation.boundary, budget);
    if (!enrichment) return enrichment.error();
    result.counts.enrichment = *enrichment;
    result.seconds.enrichment = watch.lap();
    if (budget.exhausted()) {
        result.stopReason = budget.stopReason();
        return result;
    }

    if (auto built = buildConstrainedDelaunay(*domain, context, triangulation); !built) return built.error();
    if (const std::optional<StopReason> reason = context.stopReason()) {
        result.stopReason = *reason;
        return result;
    }
    countResult(result);
    result.counts.initialVertices = result.counts.vertices;
    result.counts.initialTriangles = result.counts.triangles;
    if (options.refinement.sizing.isActive())
        setLengthScales(*domain, options.refinement.sizing, triangulation);
    result.counts.expectedTriangles =
        expectedTriangleCount(*domain, options.refinement.sizing, triangulation);
    result.seconds.initialTriangulation = watch.lap();
    if (!options.isRefined) return result;
    if (result.counts.expectedTriangles > options.mostExpectedTriangles) {
        result.stopReason = StopReason::ElementLimit;
        return result;
    }

    result.refinement = refine(*domain, options.refinement, context, budget, triangulation);
    result.stopReason = result.refinement.stopReason;
    result.seconds.refinement = watch.lap();
    countResult(result);
    return result;
}

}  // namespace mesher
