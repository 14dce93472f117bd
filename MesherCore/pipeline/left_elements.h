#pragma once

#include "pipeline/mesh_report.h"
#include "refinement/refine_volume.h"
#include "surface_sampling/sample_surface.h"

namespace mesher {

/// Tells in the report what refinement left worse than it was asked for and why, and warns of walls that are kept flat.
void tellLeftElements(const RefinedVolume& refined, MeshReport& report);

/// Warns of rims and curved walls whose facets are coarser than their thickness asks for.
void tellWalls(const SurfaceSamplingCounts& counts, MeshReport& report);

/// Where the limit of elements has ended the sampling of the surfaces: the last failure names the face with most facets.
void nameFaceOverLimit(const SurfaceMesh& mesh, MeshReport& report);

/// Where the limit of elements has ended a run, and a wall alone takes a large part of them, even with flat ones: the last
/// failure names its faces.
void nameWallOverLimit(const RefinedVolume& refined, MeshReport& report);

}  // namespace mesher
