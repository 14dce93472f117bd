#include "brep/tangent_variation.h"

#include "base/assert.h"
#include "brep/root_finding.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mesher {

namespace {

/// Turning below this, in radians, is rounding: a span of it is straight.
constexpr double kStraight = 1e-9;

/// t strictly between t0 and t1 where a double lies between them.
double strictlyInside(double t, double t0, double t1)
{
    return std::clamp(t, std::nextafter(t0, t1), std::nextafter(t1, t0));
}

double solveInCell(const TangentCell& cell, const ChebyshevSeries& series, double target)
{
    const double total = series.at(1.0);
    if (!(target > 0.0)) return cell.range.first;
    if (!(target < total)) return cell.range.last;
    const auto excess = [&](double t) { return series.at(cell.abscissa(t)) - target; };
    return findRoot(excess, cell.range.first, cell.range.last, -target, total - target, 0.0);
}

}  // namespace

TangentVariation::TangentVariation(std::shared_ptr<const Curve> curve, Interval part)
    : curve_(std::move(curve)), part_(part)
{
    MESHER_PRECONDITION(part.first < part.last);
    if (curve_->kind() == CurveKind::Line || curve_->kind() == CurveKind::Circle) {
        speed_ = length(curve_->evaluate(part.first).d1);
        turning_ = curve_->kind() == CurveKind::Circle ? 1.0 : 0.0;
        return;
    }
    table_ = tabulateTangent(*curve_, part);
}

const TangentCell& TangentVariation::cellAt(double t) const
{
    const auto isAfter = [](double value, const TangentCell& cell) { return value < cell.range.first; };
    const auto next = std::upper_bound(table_.cells.begin(), table_.cells.end(), t, isAfter);
    return next == table_.cells.begin() ? table_.cells.front() : *(next - 1);
}

double TangentVariation::smoothVariationTo(double t) const
{
    const TangentCell& cell = cellAt(t);
    return cell.variationBefore + std::max(0.0, cell.variation.at(cell.abscissa(t)));
}

double TangentVariation::lengthTo(double t) const
{
    const TangentCell& cell = cellAt(t);
    return cell.lengthBefore + std::max(0.0, cell.length.at(cell.abscissa(t)));
}

double TangentVariation::jumpsInside(double t0, double t1) const
{
    double sum = 0.0;
    for (const CurveCorner& corner : table_.corners) {
        if (t0 < corner.parameter && corner.parameter < t1) sum += corner.angle;
    }
    return sum;
}

double TangentVariation::variation(double t0, double t1) const
{
    MESHER_PRECONDITION(t0 <= t1);
    if (table_.cells.empty()) return turning_ * (t1 - t0);
    return std::max(0.0, smoothVariationTo(t1) - smoothVariationTo(t0)) + jumpsInside(t0, t1);
}

double TangentVariation::arcLength(double t0, double t1) const
{
    MESHER_PRECONDITION(t0 <= t1);
    if (table_.cells.empty()) return speed_ * (t1 - t0);
    return std::max(0.0, lengthTo(t1) - lengthTo(t0));
}

double TangentVariation::parameterAtSmoothVariation(double target) const
{
    const auto isBelow = [](const TangentCell& cell, double value) { return cell.variationBefore < value; };
    const auto next = std::lower_bound(table_.cells.begin(), table_.cells.end(), target, isBelow);
    const TangentCell& cell = next == table_.cells.begin() ? table_.cells.front() : *(next - 1);
    return solveInCell(cell, cell.variation, target - cell.variationBefore);
}

double TangentVariation::parameterAtLength(double target) const
{
    const auto isBelow = [](const TangentCell& cell, double value) { return cell.lengthBefore < value; };
    const auto next = std::lower_bound(table_.cells.begin(), table_.cells.end(), target, isBelow);
    const TangentCell& cell = next == table_.cells.begin() ? table_.cells.front() : *(next - 1);
    return solveInCell(cell, cell.length, target - cell.lengthBefore);
}

double TangentVariation::parameterAtVariation(double t0, double radians) const
{
    if (table_.cells.empty()) {
        return turning_ > 0.0 ? part_.clamp(t0 + radians / turning_) : (radians > 0.0 ? part_.last : t0);
    }
    const double start = smoothVariationTo(t0);
    double jumps = 0.0;
    for (const CurveCorner& corner : table_.corners) {
        if (corner.parameter <= t0) continue;
        const double upToCorner = smoothVariationTo(corner.parameter) - start + jumps;
        if (radians < upToCorner) break;
        if (radians <= upToCorner + corner.angle) return corner.parameter;
        jumps += corner.angle;
    }
    return std::clamp(parameterAtSmoothVariation(start + radians - jumps), t0, part_.last);
}

double TangentVariation::middleOfStraightPiece(double t, Interval span) const
{
    // A split in the open interior of a turning piece keeps its place: both ends of its neighbourhood coincide.
    const double reached = smoothVariationTo(t);
    Interval straight{std::max(span.first, parameterAtSmoothVariation(reached - kStraight)),
                      std::min(span.last, parameterAtSmoothVariation(reached + kStraight))};
    for (const CurveCorner& corner : table_.corners) {
        if (corner.parameter <= t) straight.first = std::max(straight.first, corner.parameter);
        if (corner.parameter >= t) straight.last = std::min(straight.last, corner.parameter);
    }
    if (arcLength(straight.first, straight.last) < 1e-3 * arcLength(span.first, span.last)) return t;
    return parameterAtLengthFraction(straight.first, straight.last, 0.5);
}

double TangentVariation::equalSplit(double t0, double t1) const
{
    const double total = variation(t0, t1);
    if (table_.cells.empty() || total <= kStraight) return parameterAtLengthFraction(t0, t1, 0.5);
    double split = parameterAtVariation(t0, 0.5 * total);
    if (!isCorner(split)) split = middleOfStraightPiece(split, {t0, t1});
    return strictlyInside(split, t0, t1);
}

double TangentVariation::balancedSplit(double t0, double t1) const
{
    constexpr double kLeastShare = 0.35;
    constexpr double kEnoughTurning = 46.0 * std::numbers::pi / 180.0;
    const double split = equalSplit(t0, t1);
    if (isCorner(split) || variation(t0, t1) > kEnoughTurning) return split;
    const double share = arcLength(t0, split) / arcLength(t0, t1);
    if (share < kLeastShare) return strictlyInside(parameterAtLengthFraction(t0, t1, kLeastShare), t0, t1);
    if (share > 1.0 - kLeastShare)
        return strictlyInside(parameterAtLengthFraction(t0, t1, 1.0 - kLeastShare), t0, t1);
    return split;
}

bool TangentVariation::isCorner(double t) const
{
    return std::any_of(table_.corners.begin(), table_.corners.end(),
                       [t](const CurveCorner& corner) { return corner.parameter == t; });
}

double TangentVariation::parameterAtLengthFraction(double t0, double t1, double fraction) const
{
    if (table_.cells.empty()) return Interval{t0, t1}.clamp(Interval{t0, t1}.at(fraction));
    const double start = lengthTo(t0);
    const double target = start + fraction * (lengthTo(t1) - start);
    return std::clamp(parameterAtLength(target), t0, t1);
}

}  // namespace mesher
