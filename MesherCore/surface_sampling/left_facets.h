#pragma once

#include "base/vec.h"
#include "brep/brep_ids.h"
#include "surface_sampling/face_mesh.h"

#include <cstdint>
#include <vector>

namespace mesher {

class SampledFaces;

/// Facets of one face that have smaller angles than its refinement was held to, for one reason.
struct LeftFacets
{
    BrepFaceId face;
    FacetLeft reason = FacetLeft::Resolution;
    std::uint64_t count = 0;
    double leastAngle = 180.0;  ///< degrees
    double largestAngle = 0.0;  ///< degrees
    Vec3 worst;                 ///< centroid of the facet with the least angle, model units
};

/// All of them, by face and reason. What refinement did not mark itself, as facets that a later split of their sides made, is left
/// for want of a place as well.
/// Cost   linear in the facets
[[nodiscard]] std::vector<LeftFacets> leftFacets(const SampledFaces& faces);

}  // namespace mesher
