#pragma once

#include "brep/brep_model.h"
#include "mesh/surface_mesh.h"

namespace mesher {

/// How a facet departs from its face.
struct FacetDeparture
{
    double distance = 0.0;
    bool isFlush =
        true;  ///< it keeps to the face in parameters: its edges on the face's boundary are lines of parameters there
};

/// About how far the face goes from each facet: what the middle of the facet departs from its face, and the middle of its
/// segments from their curves, beyond which faces go on. 0 for facets that are not alive.
/// Cost         a projection for each facet, two evaluations for each segment
[[nodiscard]] IdVector<FacetId, FacetDeparture> facetDepartures(const BrepModel& model,
                                                                const SurfaceMesh& mesh);

}  // namespace mesher
