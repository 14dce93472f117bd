#pragma once

#include "base/result.h"
#include "triangulation2d/boundary.h"

namespace mesher {

struct CurveSamplingOptions
{
    /// Largest total variation of the tangent over a subcurve, degrees, in [30, 90].
    double maxVariation = 90.0;
};

/// Cuts each curve into subcurves of equal total variation of the tangent, as few as the bound allows.
/// Guarantees   no subcurve turns by more than the bound; corners of the tangent inside of a curve are vertices; a closed
///              curve has at least three subcurves, and no two subcurves join the same two vertices
/// Refuses      coinciding points, and two straight curves between the same points
/// Cost         linear in the number of subcurves
/// Reference    thesis section 2.4.1
[[nodiscard]] Result<Boundary> sampleCurves(const PlanarDomain& domain, const CurveSamplingOptions& options);

}  // namespace mesher
