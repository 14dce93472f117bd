#pragma once

#include "brep/planar_curve_complex.h"
#include "pipeline/mesh_report.h"
#include "surface_sampling/left_facets.h"
#include "surface_sampling/sample_surface.h"
#include "triangulation2d/triangulate_planar.h"

#include <vector>

namespace mesher {

/// Tells in the report which triangles of faces in space have smaller angles than were asked for and why, and warns of
/// them, a line for each reason. `report.options` are those of the run.
void tellLeftTriangles(const std::vector<LeftFacets>& facets, MeshReport& report);

/// Warns of faces in space on which the angle that was asked for is out of reach.
void tellUnreachableAngles(const SurfaceSamplingCounts& counts, MeshReport& report);

/// Both of a plane domain.
void tellLeftTriangles(const PlanarCurveComplex& complex, const PlanarResult& result, MeshReport& report);

}  // namespace mesher
