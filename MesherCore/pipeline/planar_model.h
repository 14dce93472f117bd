#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "brep/planar_curve_complex.h"
#include "pipeline/mesh_options.h"

namespace mesher {

/// The faces that the options name, or all of the model, as one plane domain.
/// Refuses      names of faces that the model does not have, a model without faces, and what planarCurveComplex refuses
[[nodiscard]] Result<PlanarCurveComplex> planarModel(const BrepModel& model, const MeshOptions& options);

}  // namespace mesher
