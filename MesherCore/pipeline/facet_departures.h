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

/// A bound of how far points of each facet are from its face, and of its segments from their curves, beyond which faces go on:
/// from the centre and the edges, since where a face is a saddle it passes the centre of facets that it leaves at their edges.
/// 0 for facets that are not alive.
/// Requires     facets within which the face bends no more than a spline between a few knots
/// Cost         about one projection for each facet, ten evaluations for each facet
[[nodiscard]] IdVector<FacetId, FacetDeparture> facetDepartures(const BrepModel& model,
                                                                const SurfaceMesh& mesh);

}  // namespace mesher
