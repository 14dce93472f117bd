#pragma once

#include "improvement/improve_mesh.h"
#include "pipeline/mesh_report.h"
#include "refinement/refine_volume.h"
#include "surface_sampling/sample_surface.h"
#include "tetrahedralization/tetrahedralize.h"

namespace mesher {

/// What each stage counted, under the names that the report gives it.
void tellCounts(const SurfaceSamplingCounts& counts, MeshReport& report);
void tellCounts(const TetrahedralizationCounts& counts, MeshReport& report);
void tellCounts(const RefinedVolume& refined, MeshReport& report);
void tellCounts(const ImprovementCounts& counts, MeshReport& report);

}  // namespace mesher
