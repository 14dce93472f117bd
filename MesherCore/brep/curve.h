#pragma once

#include "base/vec.h"
#include "brep/interval.h"

#include <memory>
#include <optional>
#include <span>

namespace mesher {

/// A line is parametrised by a multiple of its length, a circle by its angle in radians, an ellipse by the eccentric anomaly.
enum class CurveKind
{
    Line,
    Circle,
    Ellipse,
    Hyperbola,
    Parabola,
    Bezier,
    BSpline,
    Other
};

/// Position and derivatives by the parameter; units: model units per unit of the parameter (squared).
struct CurvePoint
{
    Vec3 position;
    Vec3 d1;
    Vec3 d2;
};

/// The point of a curve that is closest to a given one.
struct CurveProjection
{
    double parameter = 0.0;
    Vec3 position;
    double distance = 0.0;
};

/// The geometry of a curve of a B-rep model: few questions, each with an exact answer up to rounding.
///
/// Guarantees   evaluate(t).position == position(t); derivatives are those of the exact curve
/// Requires     t in range() up to rounding; a backend may clamp
/// Threads      an object may cache: one per thread, made by clone()
class Curve
{
public:
    virtual ~Curve() = default;

    [[nodiscard]] virtual CurveKind kind() const = 0;
    [[nodiscard]] virtual Interval range() const = 0;
    [[nodiscard]] virtual Vec3 position(double t) const = 0;
    [[nodiscard]] virtual CurvePoint evaluate(double t) const = 0;
    /// Ascending parameters inside the range at which the curve is not twice continuously differentiable.
    [[nodiscard]] virtual std::span<const double> breaks() const = 0;
    /// Ascending parameters inside the range between which the curve is analytic; the breaks are among them.
    [[nodiscard]] virtual std::span<const double> knots() const { return breaks(); }
    /// Closest point within the part of the curve; global without a seed, the local minimum reached from it with one.
    [[nodiscard]] virtual CurveProjection project(const Vec3& point, Interval part,
                                                  std::optional<double> seed = {}) const = 0;
    [[nodiscard]] virtual std::unique_ptr<Curve> clone() const = 0;
};

}  // namespace mesher
