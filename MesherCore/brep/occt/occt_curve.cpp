#include "brep/occt/occt_curve.h"

#include "brep/analytic/bspline_curve.h"
#include "brep/analytic/conic_curves.h"
#include "brep/analytic/line_curve.h"
#include "brep/analytic/parameter_curves.h"
#include "brep/curve_projection.h"
#include "brep/occt/askable_parameter.h"
#include "brep/occt/occt_convert.h"
#include "brep/occt/occt_error.h"

#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Borders strictly inside of the part between which the curve has the continuity.
std::vector<double> bordersOf(const GeomAdaptor_Curve& adaptor, GeomAbs_Shape continuity)
{
    const int count = adaptor.NbIntervals(continuity);
    TColStd_Array1OfReal borders(1, count + 1);
    adaptor.Intervals(borders, continuity);
    std::vector<double> inner;
    for (int i = 2; i <= count; ++i) inner.push_back(borders(i));
    return inner;
}

CurveKind kindOf(const Handle(Geom_Curve) & geometry)
{
    if (geometry->IsKind(STANDARD_TYPE(Geom_Hyperbola))) return CurveKind::Hyperbola;
    if (geometry->IsKind(STANDARD_TYPE(Geom_Parabola))) return CurveKind::Parabola;
    if (geometry->IsKind(STANDARD_TYPE(Geom_BSplineCurve))) return CurveKind::BSpline;
    return CurveKind::Other;
}

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A curve that the kernel evaluates.
class OcctCurve final : public Curve
{
public:
    OcctCurve(std::string entity, Handle(Geom_Curve) geometry, Interval part)
        : entity_(std::move(entity)),
          geometry_(std::move(geometry)),
          adaptor_(geometry_, part.first, part.last),
          part_(part),
          period_(geometry_->IsPeriodic() ? geometry_->Period() : 0.0),
          breaks_(bordersOf(adaptor_, GeomAbs_C2)),
          knots_(bordersOf(adaptor_, GeomAbs_CN))
    {
    }

    CurveKind kind() const override { return kindOf(geometry_); }
    Interval range() const override { return part_; }
    Vec3 position(double t) const override
    {
        const double at = askableParameter(t, part_, period_);
        if (!std::isfinite(at)) return kNoPlace;
        return asked(entity_, [&] { return toVec(adaptor_.Value(at)); });
    }
    CurvePoint evaluate(double t) const override
    {
        const double at = askableParameter(t, part_, period_);
        if (!std::isfinite(at)) return {kNoPlace, kNoPlace, kNoPlace};
        gp_Pnt p;
        gp_Vec d1, d2;
        asked(entity_, [&] { adaptor_.D2(at, p, d1, d2); });
        return {toVec(p), toVec(d1), toVec(d2)};
    }
    std::span<const double> breaks() const override { return breaks_; }
    std::span<const double> knots() const override { return knots_; }
    CurveProjection project(const Vec3& point, Interval part, std::optional<double> seed) const override
    {
        constexpr int kPerPiece = 12;
        if (seed) return projectFromSeed(*this, point, part, *seed);
        return projectOnCurve(*this, point, projectionStations(*this, part, kPerPiece));
    }
    std::unique_ptr<Curve> clone() const override
    {
        return asked(entity_, [&] { return std::make_unique<OcctCurve>(entity_, geometry_, part_); });
    }

private:
    static constexpr Vec3 kNoPlace{kNoNumber, kNoNumber, kNoNumber};

    std::string entity_;
    Handle(Geom_Curve) geometry_;
    GeomAdaptor_Curve adaptor_;
    Interval part_;
    double period_;
    std::vector<double> breaks_;
    std::vector<double> knots_;
};

std::shared_ptr<const Curve> tryOwnSpline(BSplineData data)
{
    auto spline = BSplineCurve::make(std::move(data));
    return spline ? std::shared_ptr<const Curve>(*spline) : nullptr;
}

std::shared_ptr<const Curve> makeBezier(const Handle(Geom_BezierCurve) & bezier)
{
    BSplineData data;
    data.degree = static_cast<std::size_t>(bezier->Degree());
    for (int i = 1; i <= bezier->NbPoles(); ++i) {
        data.poles.push_back(toVec(bezier->Pole(i)));
        if (bezier->IsRational()) data.weights.push_back(bezier->Weight(i));
    }
    data.knots.assign(data.degree + 1, 0.0);
    data.knots.insert(data.knots.end(), data.degree + 1, 1.0);
    return tryOwnSpline(std::move(data));
}

/// Nothing for a periodic spline, whose edges may run over the end of its period.
std::shared_ptr<const Curve> makeSpline(const Handle(Geom_BSplineCurve) & spline)
{
    if (spline->IsPeriodic()) return nullptr;
    BSplineData data;
    data.degree = static_cast<std::size_t>(spline->Degree());
    for (int i = 1; i <= spline->NbPoles(); ++i) {
        data.poles.push_back(toVec(spline->Pole(i)));
        if (spline->IsRational()) data.weights.push_back(spline->Weight(i));
    }
    for (int i = 1; i <= spline->NbKnots(); ++i) {
        data.knots.insert(data.knots.end(), static_cast<std::size_t>(spline->Multiplicity(i)),
                          spline->Knot(i));
    }
    return tryOwnSpline(std::move(data));
}

class OcctParameterCurve final : public ParameterCurve
{
public:
    OcctParameterCurve(std::string entity, Handle(Geom2d_Curve) geometry, Interval own, double offset,
                       double scale)
        : entity_(std::move(entity)),
          geometry_(std::move(geometry)),
          own_(own),
          offset_(offset),
          scale_(scale),
          period_(geometry_->IsPeriodic() ? geometry_->Period() : 0.0)
    {
    }

    Vec2 position(double t) const override
    {
        const double at = askableParameter(offset_ + scale_ * t, own_, period_);
        if (!std::isfinite(at)) return {kNoNumber, kNoNumber};
        return asked(entity_, [&] { return toVec(geometry_->Value(at)); });
    }
    std::unique_ptr<ParameterCurve> clone() const override
    {
        return std::make_unique<OcctParameterCurve>(*this);
    }

private:
    std::string entity_;
    Handle(Geom2d_Curve) geometry_;  ///< evaluates without a cache, so that threads may share it
    Interval own_;
    double offset_;
    double scale_;
    double period_;
};

}  // namespace

std::shared_ptr<const Curve> makeCurve(const std::string& entity, const Handle(Geom_Curve) & geometry,
                                       Interval part)
{
    if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(geometry))
        return makeCurve(entity, trimmed->BasisCurve(), part);
    if (const auto line = Handle(Geom_Line)::DownCast(geometry)) {
        return std::make_shared<LineCurve>(toVec(line->Position().Location()),
                                           toVec(line->Position().Direction()), part);
    }
    if (const auto circle = Handle(Geom_Circle)::DownCast(geometry); circle && circle->Radius() > 0.0) {
        return std::make_shared<CircleCurve>(toAxes(circle->Position()), circle->Radius(), part);
    }
    if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(geometry);
        ellipse && ellipse->MinorRadius() > 0.0) {
        return std::make_shared<EllipseCurve>(toAxes(ellipse->Position()), ellipse->MajorRadius(),
                                              ellipse->MinorRadius(), part);
    }
    std::shared_ptr<const Curve> own;
    if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(geometry)) own = makeBezier(bezier);
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(geometry)) own = makeSpline(spline);
    return own ? own : std::make_shared<OcctCurve>(entity, geometry, part);
}

std::shared_ptr<const ParameterCurve> makeParameterCurve(const std::string& entity,
                                                         const Handle(Geom2d_Curve) & geometry, Interval own,
                                                         Interval part)
{
    const bool isSame = own == part || !(part.length() > 0.0);
    const double scale = isSame ? 1.0 : own.length() / part.length();
    const double offset = isSame ? 0.0 : own.first - scale * part.first;
    if (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(geometry)) {
        return makeParameterCurve(entity, trimmed->BasisCurve(), own, part);
    }
    if (const auto line = Handle(Geom2d_Line)::DownCast(geometry)) {
        const Vec2 start = toVec(line->Location());
        const Vec2 direction{line->Direction().X(), line->Direction().Y()};
        return std::make_shared<LineParameterCurve>(start + offset * direction, scale * direction);
    }
    return std::make_shared<OcctParameterCurve>(entity, geometry, own, offset, scale);
}

}  // namespace mesher
