#pragma once

#include "pipeline/mesh_report.h"
#include "refinement/refine_volume.h"

namespace mesher {

/// Tells in the report what refinement left worse than it was asked for and why, and warns of walls that are kept flat.
void tellLeftElements(const RefinedVolume& refined, MeshReport& report);

}  // namespace mesher
