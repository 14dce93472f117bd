#pragma once

#include "brep/analytic/axes.h"
#include "brep/surface.h"

#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

namespace mesher {

/// A surface that a plane curve, the profile (radius(v), height(v)), makes by turning u around the z axis:
/// origin + radius(v) (cos u x + sin u y) + height(v) z. Parametrised as in STEP and OCCT.
class RoundSurface : public Surface
{
public:
    static constexpr double kTurn = 2.0 * std::numbers::pi;

    [[nodiscard]] Interval rangeU() const final { return {0.0, kTurn}; }
    [[nodiscard]] double periodU() const final { return kTurn; }
    [[nodiscard]] Vec3 position(Vec2 uv) const final;
    [[nodiscard]] SurfacePoint evaluate(Vec2 uv) const final;
    /// In closed form. With a seed u and v are the periodic images nearest to it, a point on the axis keeps the seed's u,
    /// and on a cone or self-crossing torus the sheet of the seed is preferred.
    [[nodiscard]] SurfaceProjection project(const Vec3& point, std::optional<Vec2> seed = {}) const final;
    [[nodiscard]] const Axes& axes() const { return axes_; }

protected:
    explicit RoundSurface(const Axes& axes) : axes_(axes) {}
    RoundSurface(const RoundSurface&) = default;
    RoundSurface& operator=(const RoundSurface&) = default;

    struct Profile
    {
        std::array<double, 3> radius{};  ///< value and derivatives by v
        std::array<double, 3> height{};
    };
    [[nodiscard]] virtual Profile profile(double v) const = 0;
    /// v of the profile's point closest to (radius, height).
    [[nodiscard]] virtual double closestOnProfile(double radius, double height) const = 0;
    /// Has the profile points of negative radius, which are reached from the other side of the axis?
    [[nodiscard]] virtual bool crossesAxis() const { return false; }

private:
    Axes axes_;
};

class CylinderSurface final : public RoundSurface
{
public:
    CylinderSurface(const Axes& axes, double radius) : RoundSurface(axes), radius_(radius) {}

    [[nodiscard]] SurfaceKind kind() const override { return SurfaceKind::Cylinder; }
    [[nodiscard]] Interval rangeV() const override { return kUnbounded; }
    [[nodiscard]] double periodV() const override { return 0.0; }
    [[nodiscard]] std::unique_ptr<Surface> clone() const override
    {
        return std::make_unique<CylinderSurface>(*this);
    }

private:
    [[nodiscard]] Profile profile(double v) const override;
    [[nodiscard]] double closestOnProfile(double, double height) const override { return height; }

    double radius_;
};

/// Both nappes of a cone; v runs along the slant, radius(v) = radius + v sin(semiAngle).
class ConeSurface final : public RoundSurface
{
public:
    ConeSurface(const Axes& axes, double radius, double semiAngle);

    [[nodiscard]] SurfaceKind kind() const override { return SurfaceKind::Cone; }
    [[nodiscard]] Interval rangeV() const override { return kUnbounded; }
    [[nodiscard]] double periodV() const override { return 0.0; }
    [[nodiscard]] std::vector<double> pinchesV() const override { return {-radius_ / sine_}; }
    [[nodiscard]] std::unique_ptr<Surface> clone() const override
    {
        return std::make_unique<ConeSurface>(*this);
    }

private:
    [[nodiscard]] Profile profile(double v) const override;
    [[nodiscard]] double closestOnProfile(double radius, double height) const override;
    [[nodiscard]] bool crossesAxis() const override { return true; }

    double radius_;
    double sine_;
    double cosine_;
};

/// v is the latitude.
class SphereSurface final : public RoundSurface
{
public:
    SphereSurface(const Axes& axes, double radius) : RoundSurface(axes), radius_(radius) {}

    [[nodiscard]] SurfaceKind kind() const override { return SurfaceKind::Sphere; }
    [[nodiscard]] Interval rangeV() const override { return {-0.25 * kTurn, 0.25 * kTurn}; }
    [[nodiscard]] double periodV() const override { return 0.0; }
    [[nodiscard]] std::unique_ptr<Surface> clone() const override
    {
        return std::make_unique<SphereSurface>(*this);
    }

private:
    [[nodiscard]] Profile profile(double v) const override;
    [[nodiscard]] double closestOnProfile(double radius, double height) const override;

    double radius_;
};

/// v is the angle around the tube; the tube may be wider than the ring.
class TorusSurface final : public RoundSurface
{
public:
    TorusSurface(const Axes& axes, double ringRadius, double tubeRadius)
        : RoundSurface(axes), ringRadius_(ringRadius), tubeRadius_(tubeRadius)
    {
    }

    [[nodiscard]] SurfaceKind kind() const override { return SurfaceKind::Torus; }
    [[nodiscard]] Interval rangeV() const override { return {0.0, kTurn}; }
    [[nodiscard]] double periodV() const override { return kTurn; }
    [[nodiscard]] std::vector<double> pinchesV() const override;
    [[nodiscard]] std::unique_ptr<Surface> clone() const override
    {
        return std::make_unique<TorusSurface>(*this);
    }

private:
    [[nodiscard]] Profile profile(double v) const override;
    [[nodiscard]] double closestOnProfile(double radius, double height) const override;
    [[nodiscard]] bool crossesAxis() const override { return tubeRadius_ > ringRadius_; }

    double ringRadius_;
    double tubeRadius_;
};

}  // namespace mesher
