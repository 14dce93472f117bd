#pragma once

#include "base/result.h"
#include "brep/planar_curve_complex.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>
#include <string>
#include <vector>

namespace mesher {

struct PlanarSizes
{
    std::shared_ptr<const SizingField> field;  ///< none if the options ask for no sizes
    std::vector<std::string> warnings;
};

/// The sizes that the options ask for on a plane domain, as one field: the smallest of those of spaceSizes, on faces, edges and
/// vertices, by the distance to them, of the curvature and sag of the curves, and `fromFiles` (may be none), not below the least
/// size. Sizes of entities grow by distance / grading.
/// Requires     valid options
/// Refuses      a size on an entity that is not part of the domain
[[nodiscard]] Result<PlanarSizes> planarSizes(const PlanarCurveComplex& complex, const MeshOptions& options,
                                              std::shared_ptr<const SizingField> fromFiles);

}  // namespace mesher
