#pragma once

#include "mesh/region_sides.h"
#include "surface_sampling/sampled_faces.h"

#include <vector>

namespace mesher {

/// Narrow faces around a wall, such as the four sides of a plate, that are joined by edges.
struct WallRim
{
    std::vector<BrepFaceId> faces;  ///< ascending
    double width = 0.0;             ///< the least of the faces', model units
    double tets = 0.0;              ///< about as many as good facets on them bring about
};

/// The rims of thin walls for which `maxTets` do not suffice, the cheapest being made good first. Good facets on a strip are as
/// small as the strip is narrow, and what they bring about beside them is far more: up to a hundred tetrahedra for each of them.
/// A layer of 100 x 100 x 0.02 takes four million.
/// Guarantees   a rim is a face of flat facets nearly everywhere, each of which joins two faces that look at each other across
///              the solid: steps, chamfers and ribs are none
/// Requires     the first meshes, before they are refined
[[nodiscard]] std::vector<WallRim> findFlatRims(const SampledFaces& faces, const RegionSides& sides,
                                                double maxTets);

}  // namespace mesher
