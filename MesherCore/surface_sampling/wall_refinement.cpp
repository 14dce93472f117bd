#include "surface_sampling/wall_refinement.h"

#include <algorithm>
#include <cmath>

namespace mesher {
namespace {

constexpr int kMostRounds = 20;
constexpr int kRoundsOfRefinement = 200;
/// Mean edge over the longest that is allowed, where splits halve what is longer.
constexpr double kMeanEdge = 0.7;
/// Area of an equilateral triangle over its squared edge.
constexpr double kEquilateral = 0.433;

/// The edge at which a facet is fine enough.
double wantedEdge(const CoarseWallFacet& facet, double share, double leastEdges)
{
    return std::max(std::sqrt(8.0 * facet.radius * share * facet.thickness), leastEdges * facet.thickness);
}

/// Facets that it takes to make all of these fine enough.
double facetsFor(const std::vector<CoarseWallFacet>& coarse, double share, double leastEdges)
{
    double count = 0.0;
    for (const CoarseWallFacet& facet : coarse) {
        const double edge = kMeanEdge * std::min(wantedEdge(facet, share, leastEdges), facet.longest);
        count += std::max(1.0, facet.area / (kEquilateral * edge * edge));
    }
    return count;
}

std::size_t facetCount(const SampledFaces& faces)
{
    std::size_t count = 0;
    for (std::uint32_t f = 0; f < faces.model().faces.size(); ++f) {
        const SampledFace* face = faces.face(BrepFaceId(f));
        count += face != nullptr ? face->mesh.triangleCount() : 0;
    }
    return count;
}

/// The least share, from the one asked for, that the facets suffice for.
double affordableShare(const std::vector<CoarseWallFacet>& coarse, const SampledFaces& faces,
                       const WallRefinementOptions& options)
{
    constexpr double kStep = 1.25;
    constexpr double kMost = 16.0;
    const double others = static_cast<double>(facetCount(faces)) - static_cast<double>(coarse.size());
    double share = options.maxSagShare;
    while (share < kMost && others + facetsFor(coarse, share, options.leastEdges) > options.maxFacets)
        share *= kStep;
    return share;
}

/// One for each pair of faces, with the worst of its facets.
std::vector<CoarseWall> wallsOf(const std::vector<CoarseWallFacet>& coarse, const SampledFaces& faces)
{
    std::vector<CoarseWall> walls;
    for (const CoarseWallFacet& facet : coarse) {
        const std::array<BrepFaceId, 2> pair{std::min(facet.face, facet.across),
                                             std::max(facet.face, facet.across)};
        auto wall =
            std::find_if(walls.begin(), walls.end(), [&](const CoarseWall& w) { return w.face == pair; });
        if (wall == walls.end()) wall = walls.insert(walls.end(), CoarseWall{pair, 0.0, 0.0, {}});
        const double share = facet.sag / facet.thickness;
        if (share <= wall->sagShare) continue;
        const FaceMesh& mesh = faces.face(facet.face)->mesh;
        *wall = {pair, facet.thickness, share, mesh.position(mesh.triangle(facet.triangle).v[0])};
    }
    return walls;
}

}  // namespace

WallRefinement refineWalls(SampledSurface& surface, const WallRefinementOptions& options,
                           const BudgetLimits& limits, RunContext& context)
{
    WallRefinement result;
    if (options.sides == nullptr) return result;
    std::vector<CoarseWallFacet> coarse =
        WallThickness(surface, *options.sides, context).coarseFacets(options.maxSagShare, options.leastEdges);
    if (!coarse.empty()) result.sagShare = affordableShare(coarse, surface.faces(), options);
    while (!coarse.empty()) {
        const auto isFine = [&](const CoarseWallFacet& facet) {
            return facet.longest <= wantedEdge(facet, result.sagShare, options.leastEdges);
        };
        std::vector<CoarseWallFacet> split = coarse;
        std::erase_if(split, isFine);
        if (split.empty() || result.rounds >= kMostRounds) break;
        ++result.rounds;
        result.facetsSplit += split.size();
        for (const CoarseWallFacet& facet : split) surface.faces().force(facet.face, facet.triangle);
        const SamplingRounds rounds = surface.faces().refine(limits, kRoundsOfRefinement, context);
        result.refinement.rounds += rounds.rounds;
        result.refinement.segmentSplits += rounds.segmentSplits;
        result.refinement.stopReason = rounds.stopReason;
        surface.assemble();
        if (rounds.stopReason != StopReason::Done) break;
        coarse = WallThickness(surface, *options.sides, context)
                     .coarseFacets(options.maxSagShare, options.leastEdges);
    }
    if (const std::optional<StopReason> reason = context.stopReason()) result.refinement.stopReason = *reason;
    result.left = wallsOf(coarse, surface.faces());
    return result;
}

}  // namespace mesher
