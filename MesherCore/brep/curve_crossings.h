#pragma once

#include "base/vec.h"
#include "brep/planar_curve_complex.h"

#include <optional>

namespace mesher {

/// Two curves of a complex (or one twice) that meet away from a common point.
struct CurveCrossing
{
    PccCurveId a;
    PccCurveId b;
    Vec2 position;
};

/// The first pair of curves that come nearer to each other than `tolerance` away from the points they share, by subdivision
/// of curve pieces in boxes that hold them.
///
/// Guarantees   no crossing is missed: a piece that turns by less than a right angle stays within tan(turn / 2) / 2 of its
///              chord's length beside the chord. Points of the complex count as common within `tolerance` or the distance by
///              which their curves miss them.
/// Requires     curves that end near their points
/// Terminates   always: pieces shorter than the tolerance are not divided; after a million pairs two curves count as touching
/// Cost         n log n for n pieces that turn by pi / 8, while few boxes overlap
[[nodiscard]] std::optional<CurveCrossing> findCurveCrossing(const PlanarCurveComplex& complex, double tolerance);

}  // namespace mesher
