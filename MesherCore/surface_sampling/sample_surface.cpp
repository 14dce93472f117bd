#include "surface_sampling/sample_surface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

namespace mesher {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Error outOfRange(const std::string& what, const std::string& range)
{
    return {ErrorCode::InvalidArgument, what + " is out of range", "", {}, "choose a value in " + range};
}

std::optional<Error> refuseOptions(const SurfaceSamplingOptions& options)
{
    const FacetCriteriaOptions& facets = options.facets;
    if (!(facets.minAngle >= 0.0 && facets.minAngle <= 34.0))
        return outOfRange("the smallest angle", "[0, 34] degrees");
    if (!(facets.maxSize > 0.0)) return outOfRange("the largest size", "(0, infinity]");
    for (const double value :
         {facets.elementsPerTurn, facets.rho, facets.maxSag, facets.leastCurvatureSize, options.minSize}) {
        if (!(value >= 0.0) || !std::isfinite(value))
            return outOfRange("a size or a wish for curved faces", "[0, infinity)");
    }
    if (!(facets.maxNormalDeviation > 0.0 && facets.maxNormalDeviation <= 90.0)) {
        return outOfRange("the largest deviation of normals", "(0, 90] degrees");
    }
    if (!(options.encroachmentAngle >= 90.0 && options.encroachmentAngle <= 150.0)) {
        return outOfRange("the angle of encroachment", "[90, 150] degrees");
    }
    return {};
}

/// Curvature asks for nothing smaller than this share of the model.
constexpr double kLeastCurvatureShare = 2e-4;

constexpr double kFloorShare = 5e-5;

FaceRefinementOptions refinementOptions(const BrepModel& model, const SurfaceSamplingOptions& options)
{
    const double diagonal = length(model.box.extent());
    const double floor = options.minSize > 0.0
                             ? options.minSize
                             : std::min(kFloorShare * diagonal, 0.05 * options.facets.maxSize);
    FaceRefinementOptions result{options.facets, {floor, options.encroachmentAngle}};
    const double least = kLeastCurvatureShare * diagonal;
    result.criteria.leastCurvatureSize = std::max(options.facets.leastCurvatureSize, least);
    return result;
}

std::size_t aliveFacets(const SurfaceMesh& mesh)
{
    std::size_t count = 0;
    for (const SurfaceFacet& facet : mesh.facets) count += facet.isAlive() ? 1 : 0;
    return count;
}

/// A face whose mesh does not follow a split of its edges no longer fits its neighbours.
void reportLostSegments(const BrepModel& model, const SampledFaces& faces,
                        std::vector<std::pair<BrepFaceId, Error>>& failures)
{
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        const SampledFace* face = faces.face(BrepFaceId(f));
        if (face == nullptr || face->refiner.counts().lostSegments == 0) continue;
        failures.emplace_back(BrepFaceId(f), Error{ErrorCode::IntersectingConstraints,
                                                   "the mesh of the face has lost pieces of its edges",
                                                   nameOf(BrepFaceId(f)),
                                                   {},
                                                   "repair the edges of the face"});
    }
}

void countResult(SampledSurface& surface, SurfaceSamplingCounts& counts)
{
    counts.facesWithoutAngle = surface.faces().facesWithoutAngle();
    counts.refinement = surface.faces().counts();
    counts.segments = surface.faces().chains().aliveCount();
    counts.unprotectedAngles = surface.faces().chains().unprotectedCount();
    counts.vertices = surface.mesh().nodes.size();
    counts.facets = aliveFacets(surface.mesh());
}

/// Refines what has waited and is kept flat no more. Again, as long as that makes edges fine along narrow faces that are kept.
StopReason refineRims(SampledSurface& surface, const SurfaceSamplingOptions& options,
                      SurfaceSamplingCounts& counts, RunContext& context)
{
    constexpr int kMostRounds = 4;
    SampledFaces& faces = surface.faces();
    const std::vector<WallSides> kept = keptOf(counts.surveyedWalls), good = goodOf(counts.surveyedWalls);
    for (int round = 0; round < kMostRounds; ++round) {
        if (!faces.keepRimsOf(kept, good, facesOfKept(counts.surveyedStrips))) break;
        const SamplingRounds rounds = faces.refine(options.limits, options.maxRounds, context);
        counts.rounds.rounds += rounds.rounds;
        counts.rounds.segmentSplits += rounds.segmentSplits;
        surface.assemble();
        if (rounds.stopReason != StopReason::Done) return rounds.stopReason;
        if (!letFineStripsGo(surface, counts.surveyedWalls, {options.walls.sizeAt}, counts.surveyedStrips))
            break;
    }
    return StopReason::Done;
}

/// Decides which walls and narrow faces are kept flat, refines what waited for that, and makes facets fine enough for their walls.
StopReason treatWalls(SampledSurface& surface, const SurfaceSamplingOptions& options,
                      SurfaceSamplingCounts& counts, RunContext& context)
{
    counts.surveyedWalls = surveyWalls(surface, *options.walls.sides, {options.walls.sizeAt}, context);
    keepDearWalls(counts.surveyedWalls, options.walls.maxTets, options.walls.leastSize);
    counts.surveyedStrips = surveyStrips(surface, counts.surveyedWalls, {options.walls.sizeAt});
    keepDearStrips(counts.surveyedStrips, options.walls.maxStripTets, options.walls.leastSize);
    const StopReason reason = refineRims(surface, options, counts, context);
    if (reason != StopReason::Done) return reason;
    counts.walls = refineWalls(surface, options.walls, keptOf(counts.surveyedWalls), options.limits, context);
    return counts.walls.refinement.stopReason;
}

}  // namespace

Result<SurfaceSample> sampleSurface(const BrepModel& model, const SurfaceSamplingOptions& options,
                                    RunContext& context)
{
    if (std::optional<Error> error = refuseOptions(options)) return *error;
    SurfaceSample sample;
    SurfaceSamplingCounts& counts = sample.counts;

    Clock::time_point start = Clock::now();
    IdVector<NodeId, MeshNode> nodes;
    Result<CurveChains> chains = sampleCurveChains(model, options.curves, nodes, context);
    if (!chains) return chains.error();
    if (const std::optional<StopReason> reason = context.stopReason()) {
        sample.stopReason = *reason;
        return sample;
    }
    counts.curveNodes = nodes.size();
    sample.seconds.curves = secondsSince(start);

    start = Clock::now();
    const InitialSurfaceMesh initial = initialSurfaceMesh(model, *chains, nodes, options.initial, context);
    if (initial.stopReason != StopReason::Done) {
        sample.stopReason = initial.stopReason;
        return sample;
    }
    counts.initialVertices = nodes.size();
    for (const InitialFaceMesh& face : initial.faces) {
        counts.initialFacets += face.facets.size();
        counts.initialLeftAlone += face.leftAlone;
        counts.openTips += face.openTips;
    }
    sample.seconds.initial = secondsSince(start);

    start = Clock::now();
    auto faces = std::make_unique<SampledFaces>(model, std::move(*chains), std::move(nodes), initial,
                                                refinementOptions(model, options));
    if (options.walls.sides != nullptr) faces->leaveFlatOnRims(*options.walls.sides);
    counts.rounds = faces->refine(options.limits, options.maxRounds, context);
    sample.failures = faces->failures();
    reportLostSegments(model, *faces, sample.failures);
    sample.stopReason = counts.rounds.stopReason;
    sample.surface = std::make_unique<SampledSurface>(std::move(faces));
    sample.seconds.refinement = secondsSince(start);

    start = Clock::now();
    if (sample.stopReason == StopReason::Done && sample.failures.empty() && options.walls.sides != nullptr)
        sample.stopReason = treatWalls(*sample.surface, options, counts, context);
    sample.seconds.walls = secondsSince(start);

    start = Clock::now();
    if (options.maxCertificateRounds >= 0 && sample.stopReason == StopReason::Done) {
        counts.certificate = certify(*sample.surface, options.limits, options.maxCertificateRounds, context);
        sample.stopReason = counts.certificate.refinement.stopReason;
    }
    sample.seconds.certificate = secondsSince(start);
    countResult(*sample.surface, counts);
    return sample;
}

}  // namespace mesher
