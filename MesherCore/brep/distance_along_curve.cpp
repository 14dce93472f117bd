#include "brep/root_finding.h"
#include "brep/tangent_variation.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {

namespace {

/// Between neighbouring stations the tangent turns by no more than this: the distance from a point then has one
/// extremum in between at the most, unless the point is as near as the centre of curvature.
constexpr double kLargestTurn = std::numbers::pi / 16.0;

/// The squared distance from the apex, less the squared radius, and half its derivative.
struct DistanceGap
{
    double value = 0.0;
    double slope = 0.0;
};

class DistanceSearch
{
public:
    DistanceSearch(const Curve& curve, const Vec3& apex, double radius, double direction)
        : curve_(curve), apex_(apex), radius_(radius), direction_(direction)
    {
    }

    DistanceCrossing along(const std::vector<double>& stations)
    {
        DistanceCrossing result;
        DistanceGap before = gapAt(stations.front());
        for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
            const double a = stations[i], b = stations[i + 1];
            const DistanceGap after = gapAt(b);
            // At the very apex the slope is rounding; the step away from it counts instead.
            const bool startsDown = i > 0 && before.slope < 0.0;
            const bool turnsDown = !startsDown && after.slope < 0.0;
            const double top = turnsDown ? extremum(a, b, before, after) : b;
            const double valueAtTop = turnsDown ? gapAt(top).value : after.value;
            if (startsDown) result.isMonotone = false;
            if (valueAtTop >= 0.0) {
                result.parameter = crossing(a, top, before.value, valueAtTop);
                return result;
            }
            if (turnsDown) result.isMonotone = false;
            before = after;
        }
        return result;
    }

private:
    DistanceGap gapAt(double t) const
    {
        const CurvePoint p = curve_.evaluate(t);
        const Vec3 d = p.position - apex_;
        // (|d| - r) (|d| + r) loses no digit where |d| is near r.
        const double distance = length(d);
        return {(distance - radius_) * (distance + radius_), direction_ * dot(d, p.d1)};
    }

    double extremum(double a, double b, const DistanceGap& atA, const DistanceGap& atB) const
    {
        const double slopeAtA = std::max(atA.slope, 0.0);
        return findRoot([&](double t) { return gapAt(t).slope; }, a, b, slopeAtA, atB.slope, 0.0);
    }

    double crossing(double a, double b, double valueAtA, double valueAtB) const
    {
        if (!(valueAtA < 0.0)) return a;
        return findRoot([&](double t) { return gapAt(t).value; }, a, b, valueAtA, valueAtB, 0.0);
    }

    const Curve& curve_;
    Vec3 apex_;
    double radius_;
    double direction_;
};

}  // namespace

std::vector<double> TangentVariation::stations(Interval span) const
{
    std::vector<double> corners{span.first};
    for (const TangentCell& cell : table_.cells) {
        if (span.first < cell.range.first && cell.range.first < span.last) corners.push_back(cell.range.first);
    }
    corners.push_back(span.last);
    std::vector<double> stations{span.first};
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Interval piece{corners[i], corners[i + 1]};
        const double turns = variation(piece.first, piece.last) / kLargestTurn;
        const int count = 1 + static_cast<int>(std::min(turns, 1e5));
        for (int k = 1; k < count; ++k) stations.push_back(piece.at(static_cast<double>(k) / count));
        stations.push_back(piece.last);
    }
    return stations;
}

DistanceCrossing TangentVariation::parameterAtDistance(const Vec3& apex, double radius, Interval span,
                                                       CurveEnd apexEnd) const
{
    MESHER_PRECONDITION(radius > 0.0 && span.first < span.last);
    std::vector<double> along = stations(span);
    if (apexEnd == CurveEnd::Last) std::reverse(along.begin(), along.end());
    return DistanceSearch(*curve_, apex, radius, apexEnd == CurveEnd::First ? 1.0 : -1.0).along(along);
}

}  // namespace mesher
