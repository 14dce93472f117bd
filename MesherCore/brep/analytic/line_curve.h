#pragma once

#include "brep/curve.h"

namespace mesher {

/// The line origin + t direction.
class LineCurve final : public Curve
{
public:
    /// Requires a direction that is not zero; the speed of the parametrisation is its length.
    LineCurve(const Vec3& origin, const Vec3& direction, Interval range);
    /// The segment from a to b over [0, |b - a|]. Requires a != b.
    [[nodiscard]] static LineCurve between(const Vec3& a, const Vec3& b);

    [[nodiscard]] CurveKind kind() const override { return CurveKind::Line; }
    [[nodiscard]] Interval range() const override { return range_; }
    [[nodiscard]] Vec3 position(double t) const override { return origin_ + t * direction_; }
    [[nodiscard]] CurvePoint evaluate(double t) const override { return {position(t), direction_, {}}; }
    [[nodiscard]] std::span<const double> breaks() const override { return {}; }
    [[nodiscard]] CurveProjection project(const Vec3& point, Interval part,
                                          std::optional<double> seed = {}) const override;
    [[nodiscard]] std::unique_ptr<Curve> clone() const override { return std::make_unique<LineCurve>(*this); }

private:
    Vec3 origin_;
    Vec3 direction_;
    Interval range_;
};

}  // namespace mesher
