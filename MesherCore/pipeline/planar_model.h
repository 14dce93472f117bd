#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "brep/planar_curve_complex.h"
#include "pipeline/mesh_options.h"

#include <vector>

namespace mesher {

/// The faces that the options name, in their order, or all of the model.
/// Refuses      names of faces that the model does not have or that come twice, and a model without faces
[[nodiscard]] Result<std::vector<BrepFaceId>> facesToMesh(const BrepModel& model, const MeshOptions& options);

/// The faces that the options name, or all of the model, as one plane domain.
/// Refuses      what facesToMesh and planarCurveComplex refuse
[[nodiscard]] Result<PlanarCurveComplex> planarModel(const BrepModel& model, const MeshOptions& options);

}  // namespace mesher
