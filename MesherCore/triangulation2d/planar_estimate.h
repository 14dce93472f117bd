#pragma once

#include "triangulation2d/length_scale2d.h"
#include "triangulation2d/planar_domain.h"
#include "triangulation2d/planar_triangulation.h"

namespace mesher {

/// About how many triangles the refinement of an initial triangulation will make: the integral of 1 / size^2 over it.
/// Guarantees   right to about 20 % where sizes rule, and too low where only quality asks for triangles; infinite if the sizes
///              are too small for numbers
/// Requires     length scales (length_scale2d.h) if the sizing is active
/// Cost         grows with the logarithm of the ratio of sizes; a field that varies everywhere is asked a few million times
[[nodiscard]] double expectedTriangleCount(const PlanarDomain& domain, const PlanarSizing& sizing,
                                           const PlanarTriangulation& triangulation);

}  // namespace mesher
