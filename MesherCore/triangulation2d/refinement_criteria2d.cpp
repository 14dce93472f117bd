#include "triangulation2d/refinement_criteria2d.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mesher {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
/// Thesis section 2.4.3: a triangle is too large if r / LS exceeds sqrt(2) / 2.
constexpr double kSquaredSizeBound = 0.5;
/// A user's size is an edge length: halves of edges above sqrt(2) times it are nearer to it than the whole.
constexpr double kLongestOverWanted = std::numbers::sqrt2;

/// [miller2003] leaves no angle wider than 137 degrees beside small angles between segments. Between curves a triangle
/// that is left alone can be wider: that one is refined as far as it costs the small angle's own subcurves no split.
const double kCosineOfWidest = std::cos(137.0 / kDegreesPerRadian);

/// Too large by a factor of 1 to 2, 2 to 4, and so on. Finer steps give 2 % fewer triangles, but sweep over the domain
/// once for each step, which costs a third of the time in cache misses.
double sizeClass(double squaredFactor) { return std::ldexp(1.0, 2 * (std::ilogb(squaredFactor) / 2)); }

}  // namespace

RefinementCriteria2d::RefinementCriteria2d(const PlanarDomain& domain, const RefinementOptions2d& options,
                                           const PlanarTriangulation& triangulation)
    : domain_(domain),
      sizing_(options.sizing),
      t_(triangulation),
      mesh_(triangulation.mesh()),
      hasSizing_(options.sizing.isActive()),
      hasField_(options.sizing.field != nullptr)
{
    setMinAngle(options.minAngle);
}

void RefinementCriteria2d::setMinAngle(double minAngle)
{
    const double sine = std::sin(minAngle / kDegreesPerRadian);
    // A hair beyond the bound, so that triangles exactly at it are not refined for a rounding error.
    squaredBound_ =
        minAngle > 0.0 ? (1.0 + 1e-12) / (4.0 * sine * sine) : std::numeric_limits<double>::infinity();
}

RefinementVerdict2d RefinementCriteria2d::judge(TriangleId t) const
{
    const Triangle2d& record = mesh_.triangle(t);
    const Vec2 a = mesh_.position(record.v[0]);
    const Vec2 b = mesh_.position(record.v[1]);
    const Vec2 c = mesh_.position(record.v[2]);
    const TriangleShape2d shape = TriangleShape2d::of(a, b, c);
    RefinementVerdict2d verdict;
    if (hasSizing_) {
        const double mean = (mesh_.lengthScale(record.v[0]) + mesh_.lengthScale(record.v[1]) +
                             mesh_.lengthScale(record.v[2])) /
                            3.0;
        double squaredSize = kSquaredSizeBound * mean * mean;
        if (hasField_) squaredSize = std::min(squaredSize, squaredFieldBound(a, b, c, shape, squaredSize));
        if (shape.squaredRadius > squaredSize)
            verdict = {RefinementNeed2d::Size, sizeClass(shape.squaredRadius / squaredSize)};
    }
    if (verdict.need == RefinementNeed2d::Nothing && shape.squaredRatio() > squaredBound_) {
        verdict = {RefinementNeed2d::Quality, shape.squaredRatio()};
    }
    if (verdict.need == RefinementNeed2d::Nothing || !smallAngleSpannedBy(record, shape).isValid())
        return verdict;
    if (!hasAngleWiderThan(kCosineOfWidest, a, b, c)) return {};
    return {RefinementNeed2d::Quality, shape.squaredRatio()};
}

/// A triangle may hide a small place of the field between its vertices.
double RefinementCriteria2d::squaredFieldBound(Vec2 a, Vec2 b, Vec2 c, const TriangleShape2d& shape,
                                               double known) const
{
    if (shape.squaredRadius > known) return known;
    const Vec2 centroid = (1.0 / 3.0) * (a + b + c);
    const double radius = std::sqrt(shape.squaredRadius) / domain_.scale();
    const double near =
        domain_.scale() * sizing_.field->smallestNear(domain_.toSpace(centroid), 0.5 * radius);
    return near * near;
}

SmallAngleId RefinementCriteria2d::smallAngleSpannedBy(const Triangle2d& record,
                                                       const TriangleShape2d& shape) const
{
    const BoundaryVertexId a = t_.boundaryVertexOf(record.v[nextCorner(shape.shortestEdge)]);
    const BoundaryVertexId b = t_.boundaryVertexOf(record.v[previousCorner(shape.shortestEdge)]);
    if (!a.isValid() || !b.isValid()) return {};
    const BoundaryVertex& first = t_.boundary.vertices[a];
    const BoundaryVertex& last = t_.boundary.vertices[b];
    const bool isOnOneShell =
        first.shell.isValid() && first.shell == last.shell && first.shellRadius == last.shellRadius;
    return isOnOneShell ? first.shell : SmallAngleId();
}

SmallAngleId RefinementCriteria2d::smallAngleSpannedBy(TriangleId t) const
{
    const Triangle2d& record = mesh_.triangle(t);
    return smallAngleSpannedBy(record,
                               TriangleShape2d::of(mesh_.position(record.v[0]), mesh_.position(record.v[1]),
                                                   mesh_.position(record.v[2])));
}

bool RefinementCriteria2d::isTooLong(SubcurveId s) const
{
    if (!hasSizing_) return false;
    const double edge = t_.boundary.edgeLength(s);
    if (edge > mesh_.lengthScale(t_.firstVertex(s)) + mesh_.lengthScale(t_.lastVertex(s))) return true;
    if (!hasField_) return false;
    const Vec2 middle = 0.5 * (t_.boundary.from(s) + t_.boundary.to(s));
    const double near =
        domain_.scale() * sizing_.field->smallestNear(domain_.toSpace(middle), 0.25 * edge / domain_.scale());
    return edge > kLongestOverWanted * near;
}

}  // namespace mesher
