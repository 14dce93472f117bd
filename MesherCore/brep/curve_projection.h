#pragma once

#include "brep/curve.h"

#include <span>
#include <vector>

namespace mesher {

/// Ascending parameters of the part, its ends and the curve's knots among them, `perPiece` steps between neighbours.
[[nodiscard]] std::vector<double> projectionStations(const Curve& curve, Interval part, int perPiece);

/// The closest point of the part: all minima of the distance that the stations can tell apart, and the ends.
/// Guarantees   a local minimum up to rounding; the global one if between two neighbouring stations the distance has no
///              more than three extrema
[[nodiscard]] CurveProjection projectOnCurve(const Curve& curve, const Vec3& point, std::span<const double> stations);

/// The local minimum of the distance within the part that Newton's method, halved where it overshoots, reaches from the seed.
[[nodiscard]] CurveProjection projectFromSeed(const Curve& curve, const Vec3& point, Interval part, double seed);

}  // namespace mesher
