#pragma once

#include "base/run_context.h"
#include "brep/brep_model.h"
#include "pipeline/mesh_options.h"
#include "pipeline/mesh_outcome.h"
#include "sizing/sizing_field.h"

#include <memory>

namespace mesher {

/// Meshes a model as the options say: the one function that programs and people call. Of dimension 3 are the solids, of
/// dimension 2 the faces: those of one plane by the mesher of plane domains, others as a surface in space.
/// Guarantees   those of meshPlanar, meshFaces and meshSolids; the report says why there is no mesh, or not the whole one
/// Requires     `fromFiles`: the sizes of options.background and options.sizePoints, or none; 2 <= boundaryOrder <= 4
/// Refuses      a floating-point environment that is not exact, and what those three refuse
/// Terminates   within the limits of the options, with the reason
[[nodiscard]] MeshOutcome meshModel(const BrepModel& model, const MeshOptions& options,
                                    std::shared_ptr<const SizingField> fromFiles, int boundaryOrder,
                                    RunContext& context);

}  // namespace mesher
