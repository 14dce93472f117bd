#pragma once

#include "triangulation2d/triangulate_planar.h"

namespace mesher {

/// About how many triangles `triangulatePlanar` would make, told before it does: the integral of 1 / size^2 over the initial
/// triangulation. Right to about 20 % where sizes rule, and too low where only quality asks for triangles.
/// Refuses      what triangulatePlanar refuses
/// Cost         that of the initial triangulation
[[nodiscard]] Result<double> estimateTriangleCount(const PlanarCurveComplex& complex,
                                                   const PlanarOptions& options, RunContext& context);

}  // namespace mesher
