#pragma once

#include "brep/planar_curve_complex.h"

namespace mesher {

/// Area of all regions of a plane domain from its exact curves by Green's theorem; model units squared.
/// Cost         a Gauss rule of five points on sixteen panels between the knots of each curve
[[nodiscard]] double planarArea(const PlanarCurveComplex& complex);

}  // namespace mesher
