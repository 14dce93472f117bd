#pragma once

#include "brep/analytic/axes.h"
#include "brep/curve.h"

namespace mesher {

/// What circle and ellipse share: origin + a cos t x + b sin t y; the range may be any interval no longer than a turn.
class ConicCurve : public Curve
{
public:
    [[nodiscard]] Interval range() const final { return range_; }
    [[nodiscard]] Vec3 position(double t) const final;
    [[nodiscard]] CurvePoint evaluate(double t) const final;
    [[nodiscard]] std::span<const double> breaks() const final { return {}; }

protected:
    ConicCurve(const Axes& axes, double a, double b, Interval range);
    ConicCurve(const ConicCurve&) = default;
    ConicCurve& operator=(const ConicCurve&) = default;
    [[nodiscard]] const Axes& axes() const { return axes_; }

private:
    Axes axes_;
    double a_;
    double b_;
    Interval range_;
};

class CircleCurve final : public ConicCurve
{
public:
    /// Requires a positive radius.
    CircleCurve(const Axes& axes, double radius, Interval range) : ConicCurve(axes, radius, radius, range) {}

    [[nodiscard]] CurveKind kind() const override { return CurveKind::Circle; }
    /// In closed form; a point on the axis goes to the part's first point.
    [[nodiscard]] CurveProjection project(const Vec3& point, Interval part,
                                          std::optional<double> seed = {}) const override;
    [[nodiscard]] std::unique_ptr<Curve> clone() const override
    {
        return std::make_unique<CircleCurve>(*this);
    }
};

class EllipseCurve final : public ConicCurve
{
public:
    /// Requires positive half axes.
    EllipseCurve(const Axes& axes, double a, double b, Interval range) : ConicCurve(axes, a, b, range) {}

    [[nodiscard]] CurveKind kind() const override { return CurveKind::Ellipse; }
    [[nodiscard]] CurveProjection project(const Vec3& point, Interval part,
                                          std::optional<double> seed = {}) const override;
    [[nodiscard]] std::unique_ptr<Curve> clone() const override
    {
        return std::make_unique<EllipseCurve>(*this);
    }
};

}  // namespace mesher
