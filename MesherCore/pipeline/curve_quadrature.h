#pragma once

#include "brep/curve.h"
#include "mesh/curved_boundary.h"

#include <vector>

namespace mesher {

/// Gauss points on a part of a curve for flux integration by a scheme of this order of accuracy: one point for order 2, two for
/// the orders 3 and 4, as in [gosselin] figure 1.1.
/// Guarantees   points and normals of the exact curve; the weights sum to the length of the part up to an error of the fifth
///              (order 2: third) power of its parameter length
/// Requires     2 <= order <= 4; a curve in a plane across `planeNormal` (of length 1)
[[nodiscard]] std::vector<CurvedBoundaryPoint> gaussPointsOn(const Curve& curve, Interval part,
                                                             const Vec3& planeNormal, int order);

/// Fills in the points of the edge and of its halves from its parameters.
void placeGaussPoints(const Curve& curve, const Vec3& planeNormal, int order, CurvedBoundaryEdge& edge);

}  // namespace mesher
