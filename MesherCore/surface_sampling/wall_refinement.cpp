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
/// Facets that walls may be given for the sake of their thickness, over the good tetrahedra that they may take; and over the
/// facets that there are already, which sizes have asked for.
constexpr double kFacetsPerTet = 0.25;
constexpr double kFacetsPerFacet = 1.0;
/// Largest sag over thickness where chords are in the wall, so that the other side stays clear of them; and where they are
/// beyond it, so that they only make it thicker.
constexpr double kMostShareInWall = 1.0;
constexpr double kMostShareBeyond = 5.0;

/// What walls may be asked for.
class WallLimits
{
public:
    WallLimits(const WallRefinementOptions& options, const std::vector<WallSides>& kept)
        : options_(options), kept_(kept), share_(options.maxSagShare)
    {
    }

    /// Raises the share of walls that are not kept until the facets suffice for it.
    void makeAffordable(const std::vector<CoarseWallFacet>& coarse, double facets)
    {
        constexpr double kStep = 1.25;
        const double most = std::max(kFacetsPerTet * options_.maxTets, kFacetsPerFacet * facets);
        while (share_ < kMostShareInWall && facetsFor(coarse) > most) share_ *= kStep;
        share_ = std::min(share_, kMostShareInWall);
    }

    [[nodiscard]] double share() const { return share_; }
    [[nodiscard]] bool isFine(const CoarseWallFacet& facet) const
    {
        const double shortest = std::max(options_.leastEdges * facet.thickness, options_.leastSize);
        // Where no more is asked than that the sides do not cross, what counts is where the chords are.
        const double sag = isKept(facet) ? facet.chordSag : facet.sag;
        return sag <= shareOf(facet) * facet.thickness || facet.longest <= shortest;
    }

private:
    [[nodiscard]] bool isKept(const CoarseWallFacet& facet) const
    {
        return std::binary_search(kept_.begin(), kept_.end(),
                                  WallSides::of(facet.face, facet.across, facet.region));
    }
    [[nodiscard]] double shareOf(const CoarseWallFacet& facet) const
    {
        const double coarsest = facet.isInWall ? kMostShareInWall : kMostShareBeyond;
        return isKept(facet) ? coarsest : share_;
    }
    /// Beyond those that there are.
    [[nodiscard]] double facetsFor(const std::vector<CoarseWallFacet>& coarse) const
    {
        double count = 0.0;
        for (const CoarseWallFacet& facet : coarse) {
            if (isKept(facet) || isFine(facet)) continue;
            const double edge = kMeanEdge * facet.longest * std::sqrt(share_ * facet.thickness / facet.sag);
            count += std::max(0.0, facet.area / (kEquilateral * edge * edge) - 1.0);
        }
        return count;
    }

    const WallRefinementOptions& options_;
    const std::vector<WallSides>& kept_;
    double share_;
};

std::size_t facetCount(const SampledFaces& faces)
{
    std::size_t count = 0;
    for (std::uint32_t f = 0; f < faces.model().faces.size(); ++f) {
        const SampledFace* face = faces.face(BrepFaceId(f));
        count += face != nullptr ? face->mesh.triangleCount() : 0;
    }
    return count;
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
                           const std::vector<WallSides>& kept, const BudgetLimits& limits,
                           RunContext& context)
{
    WallRefinement result;
    if (options.sides == nullptr) return result;
    std::vector<CoarseWallFacet> coarse =
        WallThickness(surface, *options.sides, context).coarseFacets(options.maxSagShare, options.leastEdges);
    WallLimits wanted(options, kept);
    wanted.makeAffordable(coarse, static_cast<double>(facetCount(surface.faces())));
    if (!coarse.empty()) result.sagShare = wanted.share();
    while (!coarse.empty()) {
        std::vector<CoarseWallFacet> split = coarse;
        std::erase_if(split, [&](const CoarseWallFacet& facet) { return wanted.isFine(facet); });
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
