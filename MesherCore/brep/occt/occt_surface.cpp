#include "brep/occt/occt_surface.h"

#include "brep/analytic/bspline_surface.h"
#include "brep/analytic/plane_surface.h"
#include "brep/analytic/round_surfaces.h"
#include "brep/occt/askable_parameter.h"
#include "brep/occt/occt_convert.h"
#include "brep/occt/occt_error.h"
#include "brep/root_finding.h"
#include "brep/surface_projection.h"

#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace mesher {

namespace {

std::vector<double> innerBorders(const TColStd_Array1OfReal& borders)
{
    std::vector<double> inner;
    for (int i = borders.Lower() + 1; i < borders.Upper(); ++i) inner.push_back(borders(i));
    return inner;
}

std::vector<double> bordersU(const GeomAdaptor_Surface& adaptor)
{
    TColStd_Array1OfReal borders(1, adaptor.NbUIntervals(GeomAbs_CN) + 1);
    adaptor.UIntervals(borders, GeomAbs_CN);
    return innerBorders(borders);
}

std::vector<double> bordersV(const GeomAdaptor_Surface& adaptor)
{
    TColStd_Array1OfReal borders(1, adaptor.NbVIntervals(GeomAbs_CN) + 1);
    adaptor.VIntervals(borders, GeomAbs_CN);
    return innerBorders(borders);
}

SurfaceKind kindOf(const Handle(Geom_Surface) & geometry)
{
    if (geometry->IsKind(STANDARD_TYPE(Geom_BezierSurface))) return SurfaceKind::Bezier;
    if (geometry->IsKind(STANDARD_TYPE(Geom_BSplineSurface))) return SurfaceKind::BSpline;
    if (geometry->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion))) return SurfaceKind::Extrusion;
    if (geometry->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution))) return SurfaceKind::Revolution;
    if (geometry->IsKind(STANDARD_TYPE(Geom_OffsetSurface))) return SurfaceKind::Offset;
    return SurfaceKind::Other;
}

double bound(double value)
{
    if (Precision::IsPositiveInfinite(value)) return kUnbounded.last;
    return Precision::IsNegativeInfinite(value) ? kUnbounded.first : value;
}

/// A surface that the kernel evaluates. The adaptor keeps the last patch it was asked for.
class OcctSurface final : public Surface
{
public:
    OcctSurface(std::string entity, Handle(Geom_Surface) geometry, Interval windowU, Interval windowV)
        : entity_(std::move(entity)),
          geometry_(std::move(geometry)),
          adaptor_(geometry_),
          windowU_(windowU),
          windowV_(windowV),
          search_(windowU, windowV)
    {
        double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
        geometry_->Bounds(u0, u1, v0, v1);
        rangeU_ = {bound(u0), bound(u1)};
        rangeV_ = {bound(v0), bound(v1)};
        periodU_ = geometry_->IsUPeriodic() ? geometry_->UPeriod() : 0.0;
        periodV_ = geometry_->IsVPeriodic() ? geometry_->VPeriod() : 0.0;
        breaksU_ = bordersU(adaptor_);
        breaksV_ = bordersV(adaptor_);
    }

    SurfaceKind kind() const override { return kindOf(geometry_); }
    Interval rangeU() const override { return rangeU_; }
    Interval rangeV() const override { return rangeV_; }
    double periodU() const override { return periodU_; }
    double periodV() const override { return periodV_; }
    Vec3 position(Vec2 uv) const override
    {
        const Vec2 at = askable(uv);
        if (!isFinite(at)) return kNoPlace;
        return asked(entity_, [&] { return toVec(adaptor_.Value(at.x, at.y)); });
    }
    SurfacePoint evaluate(Vec2 uv) const override
    {
        const Vec2 at = askable(uv);
        if (!isFinite(at)) return {kNoPlace, kNoPlace, kNoPlace, kNoPlace, kNoPlace, kNoPlace};
        gp_Pnt p;
        gp_Vec du, dv, duu, dvv, duv;
        asked(entity_, [&] { adaptor_.D2(at.x, at.y, p, du, dv, duu, dvv, duv); });
        return {toVec(p), toVec(du), toVec(dv), toVec(duu), toVec(duv), toVec(dvv)};
    }
    SurfaceProjection project(const Vec3& point, std::optional<Vec2> seed) const override
    {
        return search_.project(*this, point, seed);
    }
    std::span<const double> breaksU() const override { return breaksU_; }
    std::span<const double> breaksV() const override { return breaksV_; }
    std::vector<double> pinchesV() const override
    {
        return kind() == SurfaceKind::Revolution ? axisMeetings() : std::vector<double>{};
    }
    std::unique_ptr<Surface> clone() const override
    {
        auto copy = asked(
            entity_, [&] { return std::make_unique<OcctSurface>(entity_, geometry_, windowU_, windowV_); });
        copy->search_ = search_;
        return copy;
    }

private:
    static constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    static constexpr Vec3 kNoPlace{kNoNumber, kNoNumber, kNoNumber};

    [[nodiscard]] Vec2 askable(Vec2 uv) const
    {
        return {askableParameter(uv.x, rangeU_, periodU_), askableParameter(uv.y, rangeV_, periodV_)};
    }

    /// Of a surface of revolution, whose derivative along u is as long as its radius: where that has a minimum of nothing.
    std::vector<double> axisMeetings() const
    {
        constexpr int kSteps = 64;
        constexpr double kRounding = 1e-12, kNothing = 1e-7;
        const auto slope = [&](double v) {
            const SurfacePoint p = evaluate({windowU_.first, v});
            return dot(p.du, p.duv);
        };
        const auto radius = [&](double v) { return length(evaluate({windowU_.first, v}).du); };
        std::vector<double> meetings;
        double before = windowV_.first, slopeBefore = slope(before), largest = radius(before);
        for (int i = 1; i <= kSteps; ++i) {
            const double v = windowV_.at(static_cast<double>(i) / kSteps), slopeHere = slope(v);
            largest = std::max(largest, radius(v));
            if (slopeBefore < 0.0 && slopeHere >= 0.0)
                meetings.push_back(
                    findRoot(slope, before, v, slopeBefore, slopeHere, kRounding * windowV_.length()));
            before = v;
            slopeBefore = slopeHere;
        }
        std::erase_if(meetings, [&](double v) { return radius(v) > kNothing * largest; });
        return meetings;
    }

    std::string entity_;
    Handle(Geom_Surface) geometry_;
    GeomAdaptor_Surface adaptor_;
    Interval windowU_;
    Interval windowV_;
    Interval rangeU_;
    Interval rangeV_;
    double periodU_ = 0.0;
    double periodV_ = 0.0;
    std::vector<double> breaksU_;
    std::vector<double> breaksV_;
    SurfaceSearch search_;
};

std::shared_ptr<const Surface> tryAnalytic(const Handle(Geom_Surface) & geometry)
{
    if (const auto plane = Handle(Geom_Plane)::DownCast(geometry)) {
        const Axes axes = toAxes(plane->Position());
        // A mirrored plane keeps its parameters; its normal is du x dv.
        return std::make_shared<PlaneSurface>(PlaneFrame{axes.origin, axes.x, axes.y, cross(axes.x, axes.y)});
    }
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(geometry)) {
        return std::make_shared<CylinderSurface>(toAxes(cylinder->Position()), cylinder->Radius());
    }
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(geometry)) {
        return std::make_shared<ConeSurface>(toAxes(cone->Position()), cone->RefRadius(), cone->SemiAngle());
    }
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(geometry)) {
        return std::make_shared<SphereSurface>(toAxes(sphere->Position()), sphere->Radius());
    }
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(geometry)) {
        return std::make_shared<TorusSurface>(toAxes(torus->Position()), torus->MajorRadius(),
                                              torus->MinorRadius());
    }
    return nullptr;
}

/// The kernel's spline as the project's own, unless it is periodic.
std::shared_ptr<const Surface> trySpline(const Handle(Geom_BSplineSurface) & spline, Interval windowU,
                                         Interval windowV)
{
    if (spline->IsUPeriodic() || spline->IsVPeriodic()) return nullptr;
    BSplineSurfaceData data;
    data.degreeU = static_cast<std::size_t>(spline->UDegree());
    data.degreeV = static_cast<std::size_t>(spline->VDegree());
    for (int i = 1; i <= spline->NbUKnots(); ++i) {
        data.knotsU.insert(data.knotsU.end(), static_cast<std::size_t>(spline->UMultiplicity(i)),
                           spline->UKnot(i));
    }
    for (int i = 1; i <= spline->NbVKnots(); ++i) {
        data.knotsV.insert(data.knotsV.end(), static_cast<std::size_t>(spline->VMultiplicity(i)),
                           spline->VKnot(i));
    }
    const bool isRational = spline->IsURational() || spline->IsVRational();
    for (int i = 1; i <= spline->NbUPoles(); ++i) {
        for (int j = 1; j <= spline->NbVPoles(); ++j) {
            data.poles.push_back(toVec(spline->Pole(i, j)));
            if (isRational) data.weights.push_back(spline->Weight(i, j));
        }
    }
    return std::make_shared<BSplineSurface>(std::move(data), windowU, windowV);
}

}  // namespace

std::shared_ptr<const Surface> makeSurface(const std::string& entity, const Handle(Geom_Surface) & geometry,
                                           Interval windowU, Interval windowV)
{
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(geometry)) {
        return makeSurface(entity, trimmed->BasisSurface(), windowU, windowV);
    }
    if (auto analytic = tryAnalytic(geometry)) return analytic;
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(geometry)) {
        if (auto own = trySpline(spline, windowU, windowV)) return own;
    }
    return std::make_shared<OcctSurface>(entity, geometry, windowU, windowV);
}

}  // namespace mesher
