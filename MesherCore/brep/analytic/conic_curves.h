#pragma once

#include "brep/analytic/axes.h"
#include "brep/curve.h"

namespace mesher {

/// The circle origin + radius (cos t x + sin t y); its range may be any interval no longer than a turn.
class CircleCurve final : public Curve
{
public:
    /// Requires a positive radius.
    CircleCurve(const Axes& axes, double radius, Interval range);

    [[nodiscard]] CurveKind kind() const override { return CurveKind::Circle; }
    [[nodiscard]] Interval range() const override { return range_; }
    [[nodiscard]] Vec3 position(double t) const override;
    [[nodiscard]] CurvePoint evaluate(double t) const override;
    [[nodiscard]] std::span<const double> breaks() const override { return {}; }
    /// In closed form; a point on the axis goes to the part's first point.
    [[nodiscard]] CurveProjection project(const Vec3& point, Interval part,
                                          std::optional<double> seed = {}) const override;
    [[nodiscard]] std::unique_ptr<Curve> clone() const override { return std::make_unique<CircleCurve>(*this); }

private:
    Axes axes_;
    double radius_;
    Interval range_;
};

/// The ellipse origin + a cos t x + b sin t y; its range may be any interval no longer than a turn.
class EllipseCurve final : public Curve
{
public:
    /// Requires positive half axes.
    EllipseCurve(const Axes& axes, double a, double b, Interval range);

    [[nodiscard]] CurveKind kind() const override { return CurveKind::Ellipse; }
    [[nodiscard]] Interval range() const override { return range_; }
    [[nodiscard]] Vec3 position(double t) const override;
    [[nodiscard]] CurvePoint evaluate(double t) const override;
    [[nodiscard]] std::span<const double> breaks() const override { return {}; }
    [[nodiscard]] CurveProjection project(const Vec3& point, Interval part,
                                          std::optional<double> seed = {}) const override;
    [[nodiscard]] std::unique_ptr<Curve> clone() const override { return std::make_unique<EllipseCurve>(*this); }

private:
    Axes axes_;
    double a_;
    double b_;
    Interval range_;
};

}  // namespace mesher
