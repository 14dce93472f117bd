#include "brep/displaced_curve.h"

#include "brep/curve_projection.h"

#include <algorithm>

namespace mesher {

namespace {

/// The second derivative at the first of four values at equal steps, or the last if they are given backwards.
Vec3 bendAtEnd(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double step)
{
    return (1.0 / (step * step)) * (2.0 * a - 5.0 * b + 4.0 * c - d);
}

/// The second derivatives of the cubic spline through values at equal steps.
std::vector<Vec3> bendsOf(const std::vector<Vec3>& values, double step)
{
    const std::size_t count = values.size(), last = count - 1;
    std::vector<Vec3> bends(count);
    std::vector<double> share(count, 0.0);
    bends[0] = bendAtEnd(values[0], values[1], values[2], values[3], step);
    bends[last] = bendAtEnd(values[last], values[last - 1], values[last - 2], values[last - 3], step);
    for (std::size_t i = 1; i < last; ++i) {
        const Vec3 wanted = (6.0 / (step * step)) * (values[i + 1] - 2.0 * values[i] + values[i - 1]);
        const double pivot = 4.0 - share[i - 1];
        share[i] = 1.0 / pivot;
        bends[i] = (1.0 / pivot) * (wanted - bends[i - 1]);
    }
    for (std::size_t i = last; i-- > 1;) bends[i] = bends[i] - share[i] * bends[i + 1];
    return bends;
}

}  // namespace

DisplacedCurve::DisplacedCurve(std::shared_ptr<const Curve> base, Interval part,
                               std::vector<Vec3> displacements)
    : base_(std::move(base)),
      part_(part),
      displacements_(std::move(displacements)),
      bends_(bendsOf(displacements_, part.length() / static_cast<double>(displacements_.size() - 1))),
      knots_(base_->knots().begin(), base_->knots().end())
{
    const double steps = static_cast<double>(displacements_.size() - 1);
    for (double i = 1.0; i < steps; ++i) knots_.push_back(part_.at(i / steps));
    std::sort(knots_.begin(), knots_.end());
    knots_.erase(std::unique(knots_.begin(), knots_.end()), knots_.end());
}

CurvePoint DisplacedCurve::displacementAt(double t) const
{
    const std::size_t last = displacements_.size() - 2;
    const double step = part_.length() / static_cast<double>(last + 1);
    const double place = std::max(0.0, (t - part_.first) / step);
    const std::size_t i = std::min(last, static_cast<std::size_t>(place));
    const double b = place - static_cast<double>(i), a = 1.0 - b;
    const Vec3 &from = displacements_[i], &to = displacements_[i + 1];
    const Vec3 &bendFrom = bends_[i], &bendTo = bends_[i + 1];
    const double sixth = step * step / 6.0;
    return {a * from + b * to + sixth * ((a * a * a - a) * bendFrom + (b * b * b - b) * bendTo),
            (1.0 / step) * (to - from) +
                (step / 6.0) * ((3.0 * b * b - 1.0) * bendTo - (3.0 * a * a - 1.0) * bendFrom),
            a * bendFrom + b * bendTo};
}

Vec3 DisplacedCurve::position(double t) const { return base_->position(t) + displacementAt(t).position; }

CurvePoint DisplacedCurve::evaluate(double t) const
{
    const CurvePoint base = base_->evaluate(t), by = displacementAt(t);
    return {base.position + by.position, base.d1 + by.d1, base.d2 + by.d2};
}

CurveProjection DisplacedCurve::project(const Vec3& point, Interval part, std::optional<double> seed) const
{
    constexpr int kPerPiece = 4;
    if (seed) return projectFromSeed(*this, point, part, *seed);
    return projectOnCurve(*this, point, projectionStations(*this, part, kPerPiece));
}

std::unique_ptr<Curve> DisplacedCurve::clone() const
{
    auto copy = std::make_unique<DisplacedCurve>(*this);
    copy->base_ = base_->clone();
    return copy;
}

}  // namespace mesher
