#include "support/curve_contract.h"

#include "base/random.h"
#include "brep/tangent_variation.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mesher::test {

namespace {

constexpr int kDense = 4000;
constexpr int kTrials = 12;

double angleBetween(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

class CurveTrial
{
public:
    CurveTrial(const Curve& curve, Interval part, double size)
        : curve_(curve), part_(part), size_(size), turning_(std::shared_ptr<const Curve>(curve.clone()), part)
    {
        for (int i = 0; i <= kDense; ++i)
            dense_.push_back(curve.evaluate(part.at(static_cast<double>(i) / kDense)));
    }

    std::vector<std::string> run()
    {
        for (int i = 0; i < kTrials; ++i) {
            const double t = part_.at(random_.unit());
            tryDerivatives(t);
            tryProjection(t);
            trySplit();
            tryDistance();
        }
        tryTotals();
        return std::move(broken_);
    }

private:
    template <class... Words>
    void complain(const Words&... words)
    {
        std::ostringstream text;
        text.precision(6);
        (text << ... << words);
        broken_.push_back(text.str());
    }

    bool isNearKnot(double t, double margin) const
    {
        const auto isNear = [&](double knot) { return std::abs(knot - t) <= margin; };
        return std::any_of(curve_.knots().begin(), curve_.knots().end(), isNear);
    }

    void tryDerivatives(double t)
    {
        const CurvePoint p = curve_.evaluate(t);
        if (length(p.position - curve_.position(t)) > 1e-12 * size_)
            complain("position is not evaluate, t=", t);
        double best1 = INFINITY, best2 = INFINITY;
        for (double share = 1e-2; share > 1e-6; share *= 0.25) {
            const double h = share * part_.length();
            if (!part_.contains(t - h) || !part_.contains(t + h) || isNearKnot(t, h)) continue;
            const CurvePoint before = curve_.evaluate(t - h), after = curve_.evaluate(t + h);
            const Vec3 d1 = (0.5 / h) * (after.position - before.position);
            const Vec3 d2 = (0.5 / h) * (after.d1 - before.d1);
            best1 = std::min(best1, length(d1 - p.d1));
            best2 = std::min(best2, length(d2 - p.d2));
        }
        const double unit = turning_.totalLength() / part_.length();
        if (best1 < INFINITY && best1 > 1e-4 * (unit + length(p.d1)))
            complain("d1 is wrong by ", best1, " at t=", t);
        if (best2 < INFINITY && best2 > 1e-3 * (unit / part_.length() + length(p.d2))) {
            complain("d2 is wrong by ", best2, " at t=", t);
        }
    }

    Vec3 randomPointNear(double t)
    {
        const double reach = turning_.totalLength() * random_.unit();
        const Vec3 offset{random_.between(-reach, reach), random_.between(-reach, reach),
                          random_.between(-reach, reach)};
        return curve_.position(t) + offset;
    }

    void tryProjection(double t)
    {
        const Vec3 on = curve_.position(t);
        if (curve_.project(on, part_).distance > 1e-10 * size_) {
            complain("a point of the curve is projected ", curve_.project(on, part_).distance,
                     " away, t=", t);
        }
        const double seed = part_.clamp(t + 1e-3 * part_.length());
        if (!isNearKnot(t, 2e-3 * part_.length()) &&
            curve_.project(on, part_, seed).distance > 1e-9 * size_) {
            complain("with a seed a point of the curve is projected ",
                     curve_.project(on, part_, seed).distance, " away");
        }
        const Vec3 off = randomPointNear(t);
        const CurveProjection found = curve_.project(off, part_);
        if (!part_.contains(found.parameter)) complain("a projection lies outside of the part");
        if (length(curve_.position(found.parameter) - found.position) > 1e-13 * size_)
            complain("projection off the curve");
        if (std::abs(length(found.position - off) - found.distance) > 1e-12 * size_)
            complain("wrong distance");
        double brute = INFINITY;
        for (const CurvePoint& p : dense_) brute = std::min(brute, length(p.position - off));
        if (found.distance > brute + 1e-12 * size_) {
            complain("a projection is ", found.distance - brute, " farther than a sample of the curve");
        }
        const CurveProjection seeded = curve_.project(off, part_, found.parameter);
        if (seeded.distance > found.distance + 1e-12 * size_)
            complain("a projection leaves its own solution as seed");
    }

    void tryTotals()
    {
        double turn = 0.0, arc = 0.0;
        for (int i = 0; i < kDense; ++i) {
            const CurvePoint& a = dense_[static_cast<std::size_t>(i)];
            const CurvePoint& b = dense_[static_cast<std::size_t>(i) + 1];
            arc += length(b.position - a.position);
            if (length(a.d1) > 0.0 && length(b.d1) > 0.0) turn += angleBetween(a.d1, b.d1);
        }
        // The samples miss what turns between them, so they can prove too little only up to their own error.
        const double tv = turning_.totalVariation();
        if (turn > tv + 1e-6 * (1.0 + tv))
            complain("variation ", tv, " is less than that of the samples, ", turn);
        // Around a corner the turns of one step may cancel.
        const double slack = 1e-3 * (1.0 + turn) + 5e-3 * static_cast<double>(turning_.corners().size());
        if (tv > turn + slack) complain("variation ", tv, " is more than that of the samples, ", turn);
        if (std::abs(arc - turning_.totalLength()) > 1e-4 * arc + 1e-12 * size_) {
            complain("arc length ", turning_.totalLength(), " is not that of the samples, ", arc);
        }
    }

    void trySplit()
    {
        double a = part_.at(random_.unit()), b = part_.at(random_.unit());
        if (a > b) std::swap(a, b);
        if (!(b - a > 1e-6 * part_.length())) return;
        const double m = turning_.equalSplit(a, b);
        if (!(a < m && m < b)) return complain("a split is not inside of its span");
        const double left = turning_.variation(a, m), right = turning_.variation(m, b);
        const double total = turning_.variation(a, b);
        const double jump = total - left - right;
        if (std::abs(left - right) > jump + 1e-8 * (1.0 + total))
            complain("a split halves ", total, " into ", left, " and ", right);
        const double balanced = turning_.balancedSplit(a, b);
        if (!(a < balanced && balanced < b)) return complain("a balanced split is not inside of its span");
        const double shorter = std::min(turning_.arcLength(a, balanced), turning_.arcLength(balanced, b));
        if (jump <= 1e-8 * (1.0 + total) && total < 0.03 && shorter < 0.124 * turning_.arcLength(a, b))
            complain("a balanced split leaves a half of ", shorter);
        if (total > 0.0) return;
        const double leftLength = turning_.arcLength(a, m), rightLength = turning_.arcLength(m, b);
        const double ulp =
            4e-16 * std::max(std::abs(a), std::abs(b)) * turning_.totalLength() / part_.length();
        if (std::abs(leftLength - rightLength) > 1e-9 * (leftLength + rightLength) + 4.0 * ulp) {
            complain("a straight split is not in the middle");
        }
    }

    void tryDistance()
    {
        const CurveEnd end = random_.below(2) == 0 ? CurveEnd::First : CurveEnd::Last;
        const bool fromFirst = end == CurveEnd::First;
        const Vec3 apex = curve_.position(fromFirst ? part_.first : part_.last);
        const double radius = turning_.totalLength() * random_.between(0.01, 0.9);
        const DistanceCrossing found = turning_.parameterAtDistance(apex, radius, part_, end);
        double reached = part_.length();
        if (found.parameter) {
            reached = std::abs(*found.parameter - (fromFirst ? part_.first : part_.last));
            const double error = std::abs(length(curve_.position(*found.parameter) - apex) - radius);
            if (error > 1e-11 * size_) complain("a crossing misses its ball by ", error);
        }
        double farthest = 0.0;
        for (int i = 0; i <= kDense; ++i) {
            const double share = static_cast<double>(i) / kDense;
            if (share * part_.length() > reached * (1.0 - 1e-9)) break;
            const CurvePoint& p = dense_[static_cast<std::size_t>(fromFirst ? i : kDense - i)];
            const double distance = length(p.position - apex);
            if (distance > radius + 1e-12 * size_) return complain("a crossing of the ball is not the first");
            if (found.isMonotone && distance < farthest - 1e-9 * size_) {
                return complain("a distance is called monotone that falls");
            }
            farthest = std::max(farthest, distance);
        }
    }

    const Curve& curve_;
    Interval part_;
    double size_;
    TangentVariation turning_;
    std::vector<CurvePoint> dense_;
    Random random_{20};
    std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> findBrokenPromises(const Curve& curve, Interval part, double size)
{
    return CurveTrial(curve, part, size).run();
}

}  // namespace mesher::test
