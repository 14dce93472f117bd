#pragma once

#include "base/result.h"
#include "brep/curve.h"

#include <memory>
#include <span>
#include <vector>

namespace mesher {

/// What makes a B-spline curve: flat knots (poles + degree + 1 of them); no weights means all are one.
struct BSplineData
{
    std::size_t degree = 3;
    std::vector<Vec3> poles;
    std::vector<double> weights;
    std::vector<double> knots;
};

/// A B-spline or NURBS curve of degree 1 to 25. A Bézier curve is the one without interior knots.
class BSplineCurve final : public Curve
{
public:
    /// Refuses data that do not fit together: counts, descending or non-finite knots, weights that are not positive, an
    /// interior knot of a multiplicity above the degree.
    [[nodiscard]] static Result<std::shared_ptr<const BSplineCurve>> make(BSplineData data);
    /// Over [0, 1]; two to 26 poles.
    [[nodiscard]] static Result<std::shared_ptr<const BSplineCurve>> makeBezier(std::vector<Vec3> poles,
                                                                                std::vector<double> weights = {});

    [[nodiscard]] CurveKind kind() const override;
    [[nodiscard]] Interval range() const override;
    [[nodiscard]] Vec3 position(double t) const override;
    [[nodiscard]] CurvePoint evaluate(double t) const override;
    [[nodiscard]] std::span<const double> breaks() const override { return breaks_; }
    [[nodiscard]] std::span<const double> knots() const override { return interiorKnots_; }
    [[nodiscard]] CurveProjection project(const Vec3& point, Interval part,
                                          std::optional<double> seed = {}) const override;
    [[nodiscard]] std::unique_ptr<Curve> clone() const override { return std::make_unique<BSplineCurve>(*this); }
    [[nodiscard]] const BSplineData& data() const { return data_; }

    explicit BSplineCurve(BSplineData validData);

private:
    BSplineData data_;
    std::vector<double> breaks_;
    std::vector<double> interiorKnots_;
};

}  // namespace mesher
