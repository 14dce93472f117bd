#pragma once

#include "base/budget.h"
#include "base/run_context.h"
#include "mesh/region_sides.h"
#include "mesh/wall_sides.h"
#include "surface_sampling/sampled_surface.h"
#include "surface_sampling/wall_thickness.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace mesher {

struct WallRefinementOptions
{
    /// The sides of the faces; without them there are no walls.
    const RegionSides* sides = nullptr;
    /// Good tetrahedra that walls may take, their rims included; walls that take more are kept flat.
    double maxTets = 1e6;
    /// The same for narrow faces of thick solids.
    double maxStripTets = 1e6;
    /// Walls that are thinner are kept flat as well: nothing smaller may be asked for.
    double leastSize = 0.0;
    /// The edge that is wanted at a point, for surfaces whose facets are larger; none where they are as they are wanted.
    std::function<double(const Vec3&)> sizeAt;
    /// Largest sag of a facet over the thickness of the wall behind it; most facets come out at half of that, so that a wall is
    /// as thick as it should be to 2 or 3 %.
    double maxSagShare = 0.05;
    /// Facets shorter than this many times the thickness are fine enough: a wall that is meshed as finely as it is thick
    /// is as exact as curvature and sag are asked to be.
    double leastEdges = 2.0;
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
/// off, several times the wall of a thin tube. Where `options.maxTets` is too few for the facets, they stay coarser; in walls
/// that are kept flat they are fine enough not to cross the other side, no more.
/// Guarantees   with nothing left, the sag of each facet on a thin curved wall is at most the share of its thickness that is told
/// Terminates   after 20 rounds, each of which splits every facet in question, by the limits, or when none can be split
/// Cost         per round the walls are measured, and the faces refined
/// Requires     `kept` ascends: the walls that are kept flat
[[nodiscard]] WallRefinement refineWalls(SampledSurface& surface, const WallRefinementOptions& options,
                                         const std::vector<WallSides>& kept, const BudgetLimits& limits,
                                         RunContext& context);

}  // namespace mesher
