#pragma once

#include "base/run_context.h"
#include "mesh/region_sides.h"
#include "mesh/wall_sides.h"
#include "surface_sampling/sampled_surface.h"

#include <functional>
#include <vector>

namespace mesher {

/// Where two faces come nearer to each other, across a solid, than a quarter of the edges that are wanted there.
struct SurveyedWall
{
    WallSides sides;
    double thickness = 0.0;         ///< least, model units
    Vec3 place;                     ///< where it is thinnest, model units
    double facets = 0.0;            ///< of the edges wanted, on both sides, as far as the wall is thin
    double tets = 0.0;              ///< about as many as it takes to fill it and its rims with good ones
    std::vector<BrepFaceId> rims;   ///< faces that have narrow places on the rim of the wall, ascending
    bool isKept = false;            ///< flat, with facets of the sizes wanted: it would take too many
    double needed = 0.0;            ///< budget that suffices for it and all that are cheaper
    bool isBelowLeastSize = false;  ///< thinner than the least edge that may be asked for
};

struct WallSurveyOptions
{
    /// The edge that is wanted at a point; none where facets are as large as they are wanted.
    std::function<double(const Vec3&)> sizeAt;
};

/// The walls of a surface that has the sizes wanted, with what good tetrahedra in them would be: about 2 A / t^2 for an area A of
/// both sides and a thickness t, and 16 for each piece of a rim that is as long as the wall is thick. Walls that run out,
/// as wedges and cusps do, count from the second row of facets on: those at the edge have its angle whatever their size.
/// Terminates   early when the context asks for it, with the walls found so far
/// Cost         a search in a tree of the facets for each
[[nodiscard]] std::vector<SurveyedWall> surveyWalls(const SampledSurface& surface, const RegionSides& sides,
                                                    const WallSurveyOptions& options, RunContext& context);

/// Which of them are kept flat: those for which `budget` tetrahedra do not suffice, the cheapest being made good first, and all
/// that are thinner than `leastSize`, the least edge that may be asked for.
void keepDearWalls(std::vector<SurveyedWall>& walls, double budget, double leastSize);

/// The facets on the sides of kept walls, ascending, as the surface is now: up to where a wall is as thick as its facets are long,
/// and turns into the sizes around it.
/// Requires     `kept` ascends
[[nodiscard]] std::vector<FlatWallFacet> facetsOnWalls(const SampledSurface& surface,
                                                       const RegionSides& sides,
                                                       const std::vector<WallSides>& kept,
                                                       RunContext& context);

/// The sides of those that are kept, ascending.
[[nodiscard]] std::vector<WallSides> keptOf(const std::vector<SurveyedWall>& walls);
/// And of the others.
[[nodiscard]] std::vector<WallSides> goodOf(const std::vector<SurveyedWall>& walls);

}  // namespace mesher
