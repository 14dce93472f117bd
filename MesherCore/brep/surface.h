#pragma once

#include "base/vec.h"
#include "brep/interval.h"
#include "brep/plane_frame.h"

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace mesher {

enum class SurfaceKind
{
    Plane,
    Cylinder,
    Cone,
    Sphere,
    Torus,
    Bezier,
    BSpline,
    Extrusion,
    Revolution,
    Offset,
    Other
};

/// Position and derivatives by the parameters.
struct SurfacePoint
{
    Vec3 position;
    Vec3 du;
    Vec3 dv;
    Vec3 duu;
    Vec3 duv;
    Vec3 dvv;

    /// Not normalised; zero where the parametrisation is singular.
    [[nodiscard]] Vec3 normal() const { return cross(du, dv); }
};

struct SurfaceProjection
{
    Vec2 parameters;
    Vec3 position;
    double distance = 0.0;
};

/// Principal curvatures (1 / model units), signed with respect to du x dv; the larger magnitude first.
struct SurfaceCurvature
{
    double largest = 0.0;
    double smallest = 0.0;
};

/// Range of a parameter that has no end; the bounds of a face on such a surface are finite.
inline constexpr Interval kUnbounded{-std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()};

/// The geometry of an untrimmed surface of a B-rep model.
///
/// Guarantees   projection in closed form on plane, cylinder, cone, sphere and torus; seeded Newton elsewhere, which
///              finds the stationary point that the seed leads to and says how far it is
/// Threads      an object may cache: one per thread, made by clone()
class Surface
{
public:
    virtual ~Surface() = default;

    [[nodiscard]] virtual SurfaceKind kind() const = 0;
    [[nodiscard]] virtual Interval rangeU() const = 0;
    [[nodiscard]] virtual Interval rangeV() const = 0;
    /// The period of a periodic direction, 0 where there is none.
    [[nodiscard]] virtual double periodU() const = 0;
    [[nodiscard]] virtual double periodV() const = 0;
    [[nodiscard]] virtual Vec3 position(Vec2 uv) const = 0;
    [[nodiscard]] virtual SurfacePoint evaluate(Vec2 uv) const = 0;
    /// Without a seed the closest point over the whole surface, at whatever cost. In a periodic direction the parameter is
    /// the image nearest to the seed, without one that in the range.
    [[nodiscard]] virtual SurfaceProjection project(const Vec3& point,
                                                    std::optional<Vec2> seed = {}) const = 0;
    /// The frame of a plane, in which (x, y) = (u, v).
    [[nodiscard]] virtual std::optional<PlaneFrame> planeFrame() const { return {}; }
    /// Ascending parameters inside the range between which the surface is analytic.
    [[nodiscard]] virtual std::span<const double> breaksU() const { return {}; }
    [[nodiscard]] virtual std::span<const double> breaksV() const { return {}; }
    /// Parameters v whose whole line is one point although the surface goes on beyond it, so that it meets itself there: the
    /// apex between the nappes of a cone, and where a torus whose tube is as wide as its ring meets its axis.
    [[nodiscard]] virtual std::vector<double> pinchesV() const { return {}; }
    [[nodiscard]] virtual std::unique_ptr<Surface> clone() const = 0;
};

/// Principal curvatures from the derivatives; nothing where the parametrisation is singular.
[[nodiscard]] std::optional<SurfaceCurvature> curvatureOf(const SurfacePoint& point);

}  // namespace mesher
