#pragma once

#include "base/result.h"
#include "brep/analytic/bspline_curve.h"

#include <memory>
#include <optional>
#include <span>

namespace mesher {

/// How an interpolating spline ends: with the given derivative by the parameter, which is near the arc length, or without
/// curvature.
struct SplineEnds
{
    std::optional<Vec3> firstTangent;
    std::optional<Vec3> lastTangent;
};

/// The cubic spline, twice continuously differentiable, through the points, its knots at the sums of the chords.
///
/// Requires     three points or more, finite, neighbours distinct; else an Error
/// Reference    [piegl1997] §9.2.3
[[nodiscard]] Result<std::shared_ptr<const BSplineCurve>> interpolateCubic(std::span<const Vec3> points,
                                                                           const SplineEnds& ends = {});

}  // namespace mesher
