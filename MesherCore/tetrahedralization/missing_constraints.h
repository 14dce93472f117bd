#pragma once

#include "tetrahedralization/surface_constraints.h"

namespace mesher {

/// Compares all segments and facets with the tetrahedralization: those that are there are locked, the others listed, and with
/// them the missing edges of missing facets, segments first.
/// Cost   one look-up a face of the tetrahedralization, and the star of a vertex for each segment and each missing facet
void findMissingConstraints(SurfaceConstraints& constraints);

}  // namespace mesher
