#include "surface_sampling/facet_criteria.h"

#include "sizing/size_bounds.h"
#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// What is forced comes before all that has grown by itself.
constexpr double kForced = 1e6;

double squaredRatioOf(double minAngle)
{
    if (!(minAngle > 0.0)) return std::numeric_limits<double>::infinity();
    const double sine = std::sin(minAngle * kRadiansPerDegree);
    return 1.0 / (4.0 * sine * sine);
}

}  // namespace

FacetCriteria::FacetCriteria(const FacetCriteriaOptions& options)
    : options_(options),
      squaredRatioLimit_(squaredRatioOf(options.minAngle)),
      leastAgreement_(std::cos(options.maxNormalDeviation * kRadiansPerDegree))
{
}

void FacetCriteria::setMinAngle(double minAngle)
{
    options_.minAngle = minAngle;
    squaredRatioLimit_ = squaredRatioOf(minAngle);
}

double FacetCriteria::leastAt(const Vec3& point) const
{
    double least = options_.leastCurvatureSize;
    for (const TipResolution& tip : options_.tips) {
        if (squaredLength(point - tip.tip) < tip.reach * tip.reach) least = std::max(least, tip.leastSize);
    }
    return least;
}

double FacetCriteria::sizeAt(const Vec3& point, double curvatureRadius) const
{
    double size = options_.maxSize;
    if (options_.elementsPerTurn > 0.0) {
        const double turn = 2.0 * std::numbers::pi * curvatureRadius / options_.elementsPerTurn;
        size = std::min(size, std::max(turn, leastAt(point)));
    }
    if (options_.maxSag > 0.0) {
        // The longest edge is a diameter of the largest facet.
        const double chord = std::sqrt(2.0 * curvatureRadius * options_.maxSag) / kEdgeSizeBounds.facet;
        size = std::min(size, std::max(chord, leastAt(point)));
    }
    if (options_.sizes != nullptr) size = std::min(size, options_.sizes->sizeAt(point));
    return size;
}

bool FacetCriteria::crowdsTip(const Vec3& point) const
{
    return std::any_of(options_.tips.begin(), options_.tips.end(), [&](const TipResolution& tip) {
        return squaredLength(point - tip.tip) < tip.clearance * tip.clearance;
    });
}

bool FacetCriteria::isTooLong(const FaceMesh& mesh, EdgeLink side) const
{
    const FaceVertex& a = mesh.vertex(mesh.from(side));
    const FaceVertex& b = mesh.vertex(mesh.to(side));
    const double wanted = kSegmentBound * 0.5 * (a.size + b.size);
    return squaredLength(b.position - a.position) > wanted * wanted;
}

bool FacetCriteria::isTooLongForSizes(const FaceMesh& mesh, EdgeLink side) const
{
    constexpr double kStraight = std::numeric_limits<double>::infinity();
    const Vec3 &a = mesh.position(mesh.from(side)), &b = mesh.position(mesh.to(side));
    const double wanted = kSegmentBound * 0.5 * (sizeAt(a, kStraight) + sizeAt(b, kStraight));
    return squaredLength(b - a) > wanted * wanted;
}

bool FacetCriteria::isHiding(const FaceVertex& a, const FaceVertex& b, const FaceVertex& c,
                             const FacetShape& shape) const
{
    if (!(leastAgreement_ > 0.0 && normalAgreement(a, b, c) < leastAgreement_)) return false;
    const double least = std::max({leastAt(a.position), leastAt(b.position), leastAt(c.position)});
    return shape.squaredSide[shape.longest] > least * least;
}

bool FacetCriteria::hidesSurface(const FaceMesh& mesh, TriangleId t) const
{
    const FaceTriangle& record = mesh.triangle(t);
    const FaceVertex &a = mesh.vertex(record.v[0]), &b = mesh.vertex(record.v[1]),
                     &c = mesh.vertex(record.v[2]);
    return isHiding(a, b, c, FacetShape::of(a.position, b.position, c.position));
}

FacetVerdict FacetCriteria::judge(const FaceMesh& mesh, TriangleId t) const
{
    const FaceTriangle& record = mesh.triangle(t);
    const FaceVertex& a = mesh.vertex(record.v[0]);
    const FaceVertex& b = mesh.vertex(record.v[1]);
    const FaceVertex& c = mesh.vertex(record.v[2]);
    const FacetShape shape = FacetShape::of(a.position, b.position, c.position);
    double excess = record.isForced ? kForced : 0.0;  // squared
    const double largest = kEdgeSizeBounds.facet * (a.size + b.size + c.size) / 3.0;
    excess = std::max(excess, shape.squaredRadius / (largest * largest));
    if (options_.rho > 0.0) {
        const double radius = std::min({a.curvatureRadius, b.curvatureRadius, c.curvatureRadius});
        const double wanted = std::max(radius / (2.0 * options_.rho), options_.leastCurvatureSize);
        excess = std::max(excess, shape.squaredRadius / (wanted * wanted));
    }
    // How far off the normals are is no length, but a facet that hides the surface comes before all others of its size.
    constexpr double kHidden = 4.0;
    if (isHiding(a, b, c, shape)) excess = std::max(excess, kHidden * (2.0 - normalAgreement(a, b, c)));
    // Whole octaves, in which facets leave the queue in the order of their making: neighbours follow each other, which is
    // what the cache wants, and no worst facet waits for one half as bad.
    if (excess > 1.0) return {FacetNeed::Size, std::exp2(std::ilogb(excess) / 2)};
    if (shape.squaredRatio() > squaredRatioLimit_)
        return {FacetNeed::Quality, std::sqrt(shape.squaredRatio())};
    return {};
}

}  // namespace mesher
