#pragma once

#include "brep/brep_model.h"

#include <cmath>
#include <memory>
#include <utility>

namespace mesher {

/// start + t direction.
class LineParameterCurve final : public ParameterCurve
{
public:
    LineParameterCurve(Vec2 start, Vec2 direction) : start_(start), direction_(direction) {}

    [[nodiscard]] Vec2 position(double t) const override { return start_ + t * direction_; }
    [[nodiscard]] std::unique_ptr<ParameterCurve> clone() const override
    {
        return std::make_unique<LineParameterCurve>(*this);
    }

private:
    Vec2 start_;
    Vec2 direction_;
};

/// radius (cos t, ±sin t) around the origin.
class CircleParameterCurve final : public ParameterCurve
{
public:
    CircleParameterCurve(double radius, bool isClockwise) : radius_(radius), sign_(isClockwise ? -1.0 : 1.0)
    {
    }

    [[nodiscard]] Vec2 position(double t) const override
    {
        return {radius_ * std::cos(t), sign_ * radius_ * std::sin(t)};
    }
    [[nodiscard]] std::unique_ptr<ParameterCurve> clone() const override
    {
        return std::make_unique<CircleParameterCurve>(*this);
    }

private:
    double radius_;
    double sign_;
};

/// A curve of a plane, seen in the plane's frame.
class PlanarParameterCurve final : public ParameterCurve
{
public:
    PlanarParameterCurve(std::unique_ptr<Curve> curve, const PlaneFrame& frame)
        : curve_(std::move(curve)), frame_(frame)
    {
    }

    [[nodiscard]] Vec2 position(double t) const override { return frame_.toPlane(curve_->position(t)); }
    [[nodiscard]] std::unique_ptr<ParameterCurve> clone() const override
    {
        return std::make_unique<PlanarParameterCurve>(curve_->clone(), frame_);
    }

private:
    std::unique_ptr<Curve> curve_;
    PlaneFrame frame_;
};

/// The points of a curve projected on a surface it lies on, from the seeds that a rough parameter curve gives. Where a parameter
/// makes no difference in space, the rough curve's is kept: at a pole, or as near to one as rounding brings the end of a curve,
/// a projection may have any.
class ProjectedParameterCurve final : public ParameterCurve
{
public:
    ProjectedParameterCurve(std::unique_ptr<Curve> curve, std::unique_ptr<Surface> surface,
                            std::unique_ptr<ParameterCurve> rough)
        : curve_(std::move(curve)), surface_(std::move(surface)), rough_(std::move(rough))
    {
    }

    [[nodiscard]] Vec2 position(double t) const override
    {
        constexpr double kExact = 1e-7;
        const Vec3 exact = curve_->position(t);
        const Vec2 rough = rough_->position(t);
        const auto distanceAt = [&](Vec2 uv) { return length(surface_->position(uv) - exact); };
        if (distanceAt(rough) <= kExact) return rough;
        const SurfaceProjection closest = surface_->project(exact, rough);
        for (const Vec2 uv : {Vec2{closest.parameters.x, rough.y}, Vec2{rough.x, closest.parameters.y}}) {
            if (distanceAt(uv) <= closest.distance + kExact) return uv;
        }
        return closest.parameters;
    }
    [[nodiscard]] std::unique_ptr<ParameterCurve> clone() const override
    {
        return std::make_unique<ProjectedParameterCurve>(curve_->clone(), surface_->clone(), rough_->clone());
    }
    /// What the projection begins at.
    [[nodiscard]] const ParameterCurve& rough() const { return *rough_; }

private:
    std::unique_ptr<Curve> curve_;
    std::unique_ptr<Surface> surface_;
    std::unique_ptr<ParameterCurve> rough_;
};

}  // namespace mesher
