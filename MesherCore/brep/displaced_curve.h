#pragma once

#include "brep/curve.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace mesher {

/// A curve moved by a small amount that changes along it: a cubic spline of the parameter through given displacements.
class DisplacedCurve final : public Curve
{
public:
    /// Displacements at equal steps of the parameter over the part.
    /// Requires     four of them or more
    DisplacedCurve(std::shared_ptr<const Curve> base, Interval part, std::vector<Vec3> displacements);

    [[nodiscard]] CurveKind kind() const override { return CurveKind::Other; }
    [[nodiscard]] Interval range() const override { return part_; }
    [[nodiscard]] Vec3 position(double t) const override;
    [[nodiscard]] CurvePoint evaluate(double t) const override;
    [[nodiscard]] std::span<const double> breaks() const override { return base_->breaks(); }
    [[nodiscard]] std::span<const double> knots() const override { return knots_; }
    [[nodiscard]] CurveProjection project(const Vec3& point, Interval part,
                                          std::optional<double> seed = {}) const override;
    [[nodiscard]] std::unique_ptr<Curve> clone() const override;

private:
    [[nodiscard]] CurvePoint displacementAt(double t) const;

    std::shared_ptr<const Curve> base_;
    Interval part_;
    std::vector<Vec3> displacements_;
    std::vector<Vec3> bends_;  ///< their second derivatives
    std::vector<double> knots_;
};

}  // namespace mesher
