#pragma once

#include "base/box.h"
#include "base/result.h"
#include "base/vec.h"
#include "brep/planar_curve_complex.h"
#include "brep/tangent_variation.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mesher {

/// A point on a curve, in the coordinates of the triangulation and, exactly, in space.
struct PlanarPlace
{
    Vec2 position;
    Vec3 space;
};

/// The complex as the steps of the triangulation see it: validated, in coordinates that the predicates take.
/// Guarantees   triangulation coordinates are those of the plane times `scale()`, a power of two (1 unless the model is
///              extremely large or small), in the exact range of the predicates
/// Refuses      non-finite or infinite points, ids that do not exist, curves of no length, a curve whose end is far from
///              its point, a domain without curves
/// Cost         one table of tangent variation per curve
/// Units        coordinates and lengths of the triangulation, unless said
class PlanarDomain
{
public:
    /// `complex` must outlive the domain.
    [[nodiscard]] static Result<PlanarDomain> make(const PlanarCurveComplex& complex);

    [[nodiscard]] const PlanarCurveComplex& complex() const { return *complex_; }
    [[nodiscard]] double scale() const { return scale_; }
    /// Of the points and of samples of the curves.
    [[nodiscard]] const Box2& box() const { return box_; }
    /// Diagonal of the box.
    [[nodiscard]] double size() const { return length(box_.extent()); }
    [[nodiscard]] std::size_t curveCount() const { return complex_->curves.size(); }
    [[nodiscard]] const PccCurve& curve(PccCurveId curve) const { return complex_->curves[curve.value]; }
    /// In model units and radians.
    [[nodiscard]] const TangentVariation& variation(PccCurveId curve) const
    {
        return variations_[curve.value];
    }

    [[nodiscard]] PlanarPlace place(PccPointId point) const;
    [[nodiscard]] PlanarPlace place(PccCurveId curve, double t) const;
    [[nodiscard]] Vec2 toTriangulation(const Vec3& space) const;
    [[nodiscard]] Vec3 toSpace(Vec2 position) const
    {
        return complex_->frame.toSpace((1.0 / scale_) * position);
    }
    /// Direction of the curve at an end of a span, pointing into the span; of length 1.
    [[nodiscard]] Vec2 directionInto(PccCurveId curve, Interval span, CurveEnd end) const;
    /// "Edge7" if the curve came from a model, else "curve 7".
    [[nodiscard]] std::string nameOf(PccCurveId curve) const;
    [[nodiscard]] std::string nameOf(PccPointId point) const;

private:
    explicit PlanarDomain(const PlanarCurveComplex& complex) : complex_(&complex) {}
    [[nodiscard]] Result<void> checkPoints() const;
    [[nodiscard]] Result<void> checkCurve(PccCurveId curve) const;
    void measure();

    const PlanarCurveComplex* complex_;
    double scale_ = 1.0;
    Box2 box_;
    std::vector<TangentVariation> variations_;
};

}  // namespace mesher
