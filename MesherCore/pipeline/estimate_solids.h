#pragma once

#include "brep/brep_model.h"
#include "pipeline/estimate.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

namespace mesher {

/// For the solids of a model, without meshing anything: tetrahedra of the wanted size in their volume, and layers of finer
/// ones along faces that are curved.
/// Guarantees   a factor of about two where the sizes asked for or curvature decide; where fine details of the shape do it is
///              far too low, and without the volume where that is not known
/// Requires     valid options; the field of solidSizes (may be null)
/// Cost         evaluations of faces on a grid, and of the field on at most 300,000 cells of an octree
[[nodiscard]] MeshEstimate estimateSolids(const BrepModel& model, const MeshOptions& options,
                                          const SizingField* sizes);

}  // namespace mesher
