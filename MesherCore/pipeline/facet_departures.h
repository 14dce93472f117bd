#pragma once

#include "brep/brep_model.h"
#include "mesh/surface_mesh.h"

namespace mesher {

/// About how far the face goes from each facet: what the middle of the facet departs from its face, and the middle of its
/// segments from their curves, beyond which faces go on. 0 for facets that are not alive.
/// Cost         a projection for each facet, an evaluation for each segment
[[nodiscard]] IdVector<FacetId, double> facetDepartures(const BrepModel& model, const SurfaceMesh& mesh);

}  // namespace mesher
