#pragma once

#include "brep/curve.h"
#include "brep/interval.h"
#include "brep/tangent_table.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace mesher {

/// Which end of a part of a curve.
enum class CurveEnd
{
    First,
    Last
};

/// Where a curve first leaves a ball.
struct DistanceCrossing
{
    std::optional<double> parameter;  ///< nothing if the part stays inside of the ball
    /// Does the distance grow all the way from the apex end to the crossing, or to the far end if there is none?
    bool isMonotone = true;
};

/// Total variation of the tangent's angle and arc length of a part of a curve, tabulated once.
///
/// Guarantees   variation(a, c) = variation(a, b) + jump at b + variation(b, c); exact up to rounding on lines and circles,
///              to about 1e-12 on other regular curves; splits lie strictly inside of the part unless it is one ulp wide
/// Requires     parameters within part(), ascending; a corner counts for a span that has it strictly inside
/// Cost         16 curve evaluations per cell of the table once; then no evaluation at all but in parameterAtDistance
/// Units        radians for variation, model units for length
/// Threads      as the curve: one per thread if it caches, because parameterAtDistance evaluates it
/// Reference    [gosselin] Definition 2.3, §2.4.1
class TangentVariation
{
public:
    TangentVariation(std::shared_ptr<const Curve> curve, Interval part);

    [[nodiscard]] const Curve& curve() const { return *curve_; }
    [[nodiscard]] Interval part() const { return part_; }
    [[nodiscard]] double totalVariation() const { return variation(part_.first, part_.last); }
    [[nodiscard]] double totalLength() const { return arcLength(part_.first, part_.last); }
    /// The jumps of the tangent strictly inside of the part, ascending.
    [[nodiscard]] std::span<const CurveCorner> corners() const { return table_.corners; }

    [[nodiscard]] double variation(double t0, double t1) const;
    [[nodiscard]] double arcLength(double t0, double t1) const;

    /// The least t with variation(t0, t) + (jump at t) >= `radians`; part().last if there is none.
    [[nodiscard]] double parameterAtVariation(double t0, double radians) const;
    /// Halves the variation of [t0, t1]: at a corner if that carries the middle, in the middle of a straight piece if that
    /// joins two equal halves, by arc length if all is straight.
    [[nodiscard]] double equalSplit(double t0, double t1) const;
    /// The same where the part turns by more than 46 degrees; else no half is shorter than 0.35 of the whole, unless it is at a
    /// corner. Equal splits of a piece whose curvature grows towards one end make ever shorter pieces there, a third of the one
    /// before each, which no angle of a facet can do with; and where all beyond is straight, they never come past the turn.
    [[nodiscard]] double balancedSplit(double t0, double t1) const;
    [[nodiscard]] double parameterAtLengthFraction(double t0, double t1, double fraction) const;

    /// The first t, going from that end of [t0, t1], with |C(t) - apex| = radius.
    /// Requires     the end lies in the ball
    [[nodiscard]] DistanceCrossing parameterAtDistance(const Vec3& apex, double radius, Interval span,
                                                       CurveEnd apexEnd) const;

private:
    [[nodiscard]] const TangentCell& cellAt(double t) const;
    [[nodiscard]] double smoothVariationTo(double t) const;
    [[nodiscard]] double lengthTo(double t) const;
    [[nodiscard]] double jumpsInside(double t0, double t1) const;
    [[nodiscard]] double parameterAtSmoothVariation(double target) const;
    [[nodiscard]] double parameterAtLength(double target) const;
    [[nodiscard]] bool isCorner(double t) const;
    [[nodiscard]] double middleOfStraightPiece(double t, Interval span) const;
    [[nodiscard]] std::vector<double> stations(Interval span) const;

    std::shared_ptr<const Curve> curve_;
    Interval part_;
    TangentTable table_;    ///< without cells on a line and a circle
    double turning_ = 0.0;  ///< radians per unit of the parameter on a line or circle
    double speed_ = 0.0;    ///< model units per unit of the parameter on a line or circle
};

}  // namespace mesher
