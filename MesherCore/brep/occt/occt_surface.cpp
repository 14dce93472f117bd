#include "brep/occt/occt_surface.h"

#include "brep/analytic/periodic.h"
#include "brep/analytic/plane_surface.h"
#include "brep/analytic/round_surfaces.h"
#include "brep/occt/occt_convert.h"
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

/// The range where it ends, the window where it does not.
Interval searchWindow(Interval range, Interval window, double period)
{
    if (period > 0.0) return {range.first, range.first + period};
    const double margin = window.length();
    return {std::isfinite(range.first) ? range.first : window.first - margin,
            std::isfinite(range.last) ? range.last : window.last + margin};
}

/// A surface that the kernel evaluates. The adaptor keeps the last patch it was asked for.
class OcctSurface final : public Surface
{
public:
    OcctSurface(Handle(Geom_Surface) geometry, Interval windowU, Interval windowV)
        : geometry_(std::move(geometry)), adaptor_(geometry_), windowU_(windowU), windowV_(windowV)
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
    Vec3 position(Vec2 uv) const override { return toVec(adaptor_.Value(uv.x, uv.y)); }
    SurfacePoint evaluate(Vec2 uv) const override
    {
        gp_Pnt p;
        gp_Vec du, dv, duu, dvv, duv;
        adaptor_.D2(uv.x, uv.y, p, du, dv, duu, dvv, duv);
        return {toVec(p), toVec(du), toVec(dv), toVec(duu), toVec(duv), toVec(dvv)};
    }
    SurfaceProjection project(const Vec3& point, std::optional<Vec2> seed) const override
    {
        if (seed) return projectFromSeed(*this, point, *seed, rangeU_, rangeV_);
        if (!grids_) grids_ = std::make_shared<const Grids>(makeGrids());
        SurfaceProjection found = grids_->face.project(*this, point);
        const SurfaceProjection elsewhere = grids_->whole.project(*this, point);
        if (elsewhere.distance < found.distance) found = elsewhere;
        if (periodU_ > 0.0) found.parameters.x = wrapInto(found.parameters.x, rangeU_.first, periodU_);
        if (periodV_ > 0.0) found.parameters.y = wrapInto(found.parameters.y, rangeV_.first, periodV_);
        return found;
    }
    std::span<const double> breaksU() const override { return breaksU_; }
    std::span<const double> breaksV() const override { return breaksV_; }
    std::unique_ptr<Surface> clone() const override
    {
        auto copy = std::make_unique<OcctSurface>(geometry_, windowU_, windowV_);
        copy->grids_ = grids_;
        return copy;
    }

private:
    /// The face may be small on its surface: a grid of its own finds what the coarse one of the whole surface misses.
    struct Grids
    {
        SurfaceGrid face;
        SurfaceGrid whole;
    };

    Grids makeGrids() const
    {
        return {SurfaceGrid(*this, windowU_, windowV_),
                SurfaceGrid(*this, searchWindow(rangeU_, windowU_, periodU_), searchWindow(rangeV_, windowV_, periodV_))};
    }

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
    mutable std::shared_ptr<const Grids> grids_;  ///< made at the first search without a seed
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
        return std::make_shared<TorusSurface>(toAxes(torus->Position()), torus->MajorRadius(), torus->MinorRadius());
    }
    return nullptr;
}

}  // namespace

std::shared_ptr<const Surface> makeSurface(const Handle(Geom_Surface) & geometry, Interval windowU, Interval windowV)
{
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(geometry)) {
        return makeSurface(trimmed->BasisSurface(), windowU, windowV);
    }
    if (auto analytic = tryAnalytic(geometry)) return analytic;
    return std::make_shared<OcctSurface>(geometry, windowU, windowV);
}

}  // namespace mesher
