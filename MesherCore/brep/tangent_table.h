#pragma once

#include "brep/chebyshev_series.h"
#include "brep/curve.h"
#include "brep/interval.h"

#include <vector>

namespace mesher {

/// A jump of the tangent's direction inside of a curve.
struct CurveCorner
{
    double parameter = 0.0;
    double angle = 0.0;  ///< radians, in (0, pi]
};

/// A piece of a curve on which the turning of the tangent and the arc length are series in the parameter.
struct TangentCell
{
    Interval range;
    double variationBefore = 0.0;  ///< total up to range.first, without the jump that may be there
    double lengthBefore = 0.0;
    double jumpBefore = 0.0;    ///< the sum of the jumps in (start of the table, range.first]
    ChebyshevSeries variation;  ///< from range.first, over the range mapped to [-1, 1]
    ChebyshevSeries length;

    [[nodiscard]] double abscissa(double t) const
    {
        return ((t - range.first) - (range.last - t)) / (range.last - range.first);
    }
};

/// The turning of the tangent of a curve, tabulated: cells of [first, last] without gaps, and the jumps between them.
struct TangentTable
{
    std::vector<TangentCell> cells;
    std::vector<CurveCorner> corners;  ///< ascending, each at the border of two cells
    double variation = 0.0;            ///< of the whole, jumps included
    double length = 0.0;
};

/// Tabulates the part of the curve by Chebyshev interpolation of curvature times speed, and of speed, on cells that are
/// halved until the series end; cells are cut first at the curve's knots and where a plane curve has an inflexion.
///
/// Guarantees   error of variation and relative error of length around 1e-12 per cell on a regular curve, or what rounding of
///              places leaves where the curve lies many times its size from the origin
/// Terminates   always: cells below 1e-10 of the part, as at a cusp, keep what the tangents at their ends tell
/// Cost         16 evaluations per cell and halving; 2 to 10 cells for a usual span
[[nodiscard]] TangentTable tabulateTangent(const Curve& curve, Interval part);

}  // namespace mesher
