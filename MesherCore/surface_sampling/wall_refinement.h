#pragma once

#include "base/budget.h"
#include "base/run_context.h"
#include "mesh/region_sides.h"
#include "surface_sampling/sampled_surface.h"
#include "surface_sampling/wall_thickness.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mesher {

struct WallRefinementOptions
{
    /// The sides of the faces; without them there are no walls.
    const RegionSides* sides = nullptr;
    /// Largest sag of a facet's longest edge over the thickness of the wall behind it; most facets come out at half of that, so
    /// that a wall is as thick as it should be to 2 or 3 %.
    double maxSagShare = 0.05;
    /// Facets shorter than this many times the thickness are fine enough: a wall that is meshed as finely as it is thick
    /// is as exact as curvature and sag are asked to be.
    double leastEdges = 2.0;
    /// Facets that the surfaces may have after it; where that is too few, the share grows as it must.
    double maxFacets = 250'000.0;
    /// Tetrahedra that good facets on the rims of walls may bring about; rims that take more keep flat ones (see WallRim).
    double maxRimTets = 1e6;
};

/// A wall whose facets stay coarser than they should be for its thickness.
struct CoarseWall
{
    std::array<BrepFaceId, 2> face;
    double thickness = 0.0;  ///< model units
    double sagShare = 0.0;   ///< the largest
    Vec3 place;
};

struct WallRefinement
{
    int rounds = 0;
    std::size_t facetsSplit = 0;
    double sagShare =
        0.0;  ///< that was kept to, the one that was asked for or a larger one; 0 if no wall is thin
    std::vector<CoarseWall> left;
    SamplingRounds refinement;
};

/// Splits facets of curved faces until they follow their surface closely in comparison with the thickness of the wall behind
/// them. Else the chords of a thin shell eat its thickness: with 12 edges a turn, a facet of a tube is 3.4 % of the radius
/// off, several times the wall of a thin tube.
/// Guarantees   with nothing left, the sag of each facet on a thin curved wall is at most the share of its thickness that is told
/// Terminates   after 20 rounds, each of which splits every facet in question, by the limits, or when none can be split
/// Cost         per round the walls are measured, and the faces refined
[[nodiscard]] WallRefinement refineWalls(SampledSurface& surface, const WallRefinementOptions& options,
                                         const BudgetLimits& limits, RunContext& context);

}  // namespace mesher
