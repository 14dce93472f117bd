#pragma once

#include "base/result.h"
#include "brep/planar_curve_complex.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>

namespace mesher {

/// The sizes that the options ask for on a plane domain, as one field: the smallest of the uniform size, those on single edges
/// and vertices, those of the curvature and sag of the curves, and `background` (may be none), not below the least size.
/// Sizes of curves and points grow by distance / grading. Nothing if the options ask for none.
/// Refuses      a local size on an entity that is not part of the domain, or on a face of several
[[nodiscard]] Result<std::shared_ptr<const SizingField>>
planarSizes(const PlanarCurveComplex& complex, const MeshOptions& options,
            std::shared_ptr<const SizingField> background);

}  // namespace mesher
