#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "brep/planar_curve_complex.h"

namespace mesher {

/// The plane faces of a model as one domain: a region for each face, named after it; edges that two faces share lie between
/// them; the domain has the plane of the first face.
/// Refuses      a model without faces; a face that is not plane, or in another plane than the first, by name
[[nodiscard]] Result<PlanarCurveComplex> complexOfPlaneFaces(const BrepModel& model);

}  // namespace mesher
