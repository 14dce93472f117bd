#include "brep/curve_projection.h"

#include "brep/root_finding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesher {

namespace {

/// Half the derivative of the squared distance, and the derivative of that, where they were taken.
struct Slope
{
    double first = 0.0;
    double second = 0.0;
    Vec3 place;
};

Slope slopeAt(const Curve& curve, const Vec3& point, double t)
{
    const CurvePoint p = curve.evaluate(t);
    const Vec3 d = p.position - point;
    return {dot(d, p.d1), dot(p.d1, p.d1) + dot(d, p.d2), p.position};
}

/// A step between two stations, or a part of it.
struct Step
{
    double a = 0.0;
    double b = 0.0;
    Slope atA;
    Slope atB;
};

CurveProjection projectionAt(const Curve& curve, const Vec3& point, double t)
{
    const Vec3 position = curve.position(t);
    return {t, position, length(position - point)};
}

class ClosestPoint
{
public:
    ClosestPoint(const Curve& curve, const Vec3& point) : curve_(curve), point_(point)
    {
        best_.distance = std::numeric_limits<double>::infinity();
    }

    void offer(double t)
    {
        const CurveProjection candidate = projectionAt(curve_, point_, t);
        if (candidate.distance < best_.distance) best_ = candidate;
    }

    /// Offers the minimum between a and b if the slope at a is negative and at b positive.
    void search(double a, double b, const Slope& atA, const Slope& atB)
    {
        if (!(atA.first < 0.0 && atB.first > 0.0)) return;
        const auto slope = [&](double t) { return slopeAt(curve_, point_, t).first; };
        offer(findRoot(slope, a, b, atA.first, atB.first, 0.0));
    }

    /// Where the slope itself turns, a minimum and a maximum may hide between two stations of equal sign.
    void searchTurning(double a, double b, const Slope& atA, const Slope& atB)
    {
        const auto change = [&](double t) { return slopeAt(curve_, point_, t).second; };
        const double turn = findRoot(change, a, b, atA.second, atB.second, 0.0);
        const Slope atTurn = slopeAt(curve_, point_, turn);
        search(a, turn, atA, atTurn);
        search(turn, b, atTurn, atB);
    }

    void searchStep(const Step& step)
    {
        if ((step.atA.second > 0.0) != (step.atB.second > 0.0)) {
            searchTurning(step.a, step.b, step.atA, step.atB);
        } else {
            search(step.a, step.b, step.atA, step.atB);
        }
    }

    /// Halves the step as long as the curve may come nearer in it than what is known: at the tip of a spike it turns back within
    /// a small part of a step, and slopes at the ends of the step tell nothing of it.
    void searchHalves(const Step& step, int depth)
    {
        constexpr int kMostHalvings = 7;
        /// A curve between two stations is longer than the chords over its middle, by less than this factor.
        constexpr double kLengthByChords = 1.5;
        constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
        const double middle = 0.5 * (step.a + step.b);
        if (depth >= kMostHalvings || !(middle > step.a && middle < step.b)) return;
        if (best_.distance <= kRounding * (length(point_) + length(best_.position))) return;
        const Slope atMiddle = slopeAt(curve_, point_, middle);
        const double chords =
            length(atMiddle.place - step.atA.place) + length(step.atB.place - atMiddle.place);
        const double ends = length(step.atA.place - point_) + length(step.atB.place - point_);
        if (0.5 * (ends - kLengthByChords * chords) >= best_.distance) return;
        offer(middle);
        for (const Step& half :
             {Step{step.a, middle, step.atA, atMiddle}, Step{middle, step.b, atMiddle, step.atB}}) {
            searchStep(half);
            searchHalves(half, depth + 1);
        }
    }

    [[nodiscard]] const CurveProjection& best() const { return best_; }

private:
    const Curve& curve_;
    Vec3 point_;
    CurveProjection best_;
};

}  // namespace

std::vector<double> projectionStations(const Curve& curve, Interval part, int perPiece)
{
    std::vector<double> borders{part.first};
    for (const double knot : curve.knots()) {
        if (borders.back() < knot && knot < part.last) borders.push_back(knot);
    }
    borders.push_back(part.last);
    std::vector<double> stations;
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        const Interval piece{borders[i], borders[i + 1]};
        for (int k = 0; k < perPiece; ++k) stations.push_back(piece.at(static_cast<double>(k) / perPiece));
    }
    stations.push_back(part.last);
    return stations;
}

CurveProjection projectOnCurve(const Curve& curve, const Vec3& point, std::span<const double> stations)
{
    // At a break the derivatives are those of its right side; this share of a step before it they are of its left side.
    // What lies between differs from the break by a distance of second order.
    constexpr double kBeforeBreak = 1e-7;
    ClosestPoint closest(curve, point);
    closest.offer(stations.front());
    Slope before = slopeAt(curve, point, stations.front());
    std::vector<Step> steps;
    steps.reserve(stations.size());
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
        const double a = stations[i], end = stations[i + 1];
        const Slope atEnd = slopeAt(curve, point, end);
        const bool isBreak = std::binary_search(curve.breaks().begin(), curve.breaks().end(), end);
        const double b = isBreak ? end - kBeforeBreak * (end - a) : end;
        const Slope after = isBreak ? slopeAt(curve, point, b) : atEnd;
        closest.offer(end);
        steps.push_back({a, b, before, after});
        closest.searchStep(steps.back());
        before = atEnd;
    }
    for (const Step& step : steps) closest.searchHalves(step, 0);
    return closest.best();
}

CurveProjection projectFromSeed(const Curve& curve, const Vec3& point, Interval part, double seed)
{
    constexpr int kMostSteps = 50;
    constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
    double t = part.clamp(seed);
    double distance = length(curve.position(t) - point);
    for (int step = 0; step < kMostSteps; ++step) {
        const CurvePoint p = curve.evaluate(t);
        const Vec3 d = p.position - point;
        const double speed2 = squaredLength(p.d1);
        const double slope = dot(d, p.d1);
        const double change = speed2 + dot(d, p.d2);
        if (!(speed2 > 0.0)) break;
        // Towards a maximum Newton's step would climb; the step of the tangent line descends.
        double move = -slope / (change > 0.1 * speed2 ? change : speed2);
        double next = part.clamp(t + move);
        double nextDistance = length(curve.position(next) - point);
        while (nextDistance > distance && std::abs(next - t) > kRounding * std::abs(t)) {
            move *= 0.5;
            next = part.clamp(t + move);
            nextDistance = length(curve.position(next) - point);
        }
        const bool isAtRest = std::abs(next - t) <= kRounding * (std::abs(t) + part.length());
        if (nextDistance <= distance) {
            t = next;
            distance = nextDistance;
        }
        if (isAtRest) break;
    }
    return projectionAt(curve, point, t);
}

}  // namespace mesher
