#include "surface_sampling/face_geometry.h"

#include <algorithm>
#include <cmath>

namespace mesher {
namespace {

/// A derivative that moves a point by less than this share of what the other one does, over the face, is that of a pole.
constexpr double kPoleRatio = 1e-9;
/// Within the gaps of a file poles may have that extent, as a share of the face.
constexpr double kMostPoleRatio = 1e-3;
/// Where the normal at a pole is asked instead, as a share of the way to the middle of the face's parameters.
constexpr double kBesidePole = 1e-4;

/// Edges that files mark as poles miss their vertex by a gap; what the surface's derivatives make of so short a line is noise.
double squaredPoleExtent(const BrepFace& face)
{
    constexpr double kGapsAlongPole = 4.0;
    double gap = 0.0;
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) gap = std::max(gap, coedge.gap);
    }
    return kGapsAlongPole * kGapsAlongPole * gap * gap;
}

double periodShift(double from, double to, double period)
{
    return period > 0.0 ? period * std::round((to - from) / period) : 0.0;
}

}  // namespace

FaceGeometry::FaceGeometry(const BrepFace& face)
    : surface_(face.surface->clone()),
      periods_{surface_->periodU(), surface_->periodV()},
      boundsU_(face.boundsU),
      boundsV_(face.boundsV),
      unit_{boundsU_.length() > 0.0 ? boundsU_.length() : 1.0,
            boundsV_.length() > 0.0 ? boundsV_.length() : 1.0},
      rangeU_(surface_->rangeU()),
      rangeV_(surface_->rangeV()),
      squaredPoleExtent_(squaredPoleExtent(face)),
      isPlane_(surface_->planeFrame().has_value())
{
}

Vec2 FaceGeometry::shiftBetween(Vec2 near, Vec2 target) const
{
    return {periodShift(near.x, target.x, periods_.x), periodShift(near.y, target.y, periods_.y)};
}

bool FaceGeometry::isCounterClockwise(Vec2 a, Vec2 b, Vec2 c) const
{
    constexpr double kFlat = 1e-9;
    const auto scaled = [this](Vec2 side) { return Vec2{side.x / unit_.x, side.y / unit_.y}; };
    const Vec2 ab = scaled(b - a), ac = scaled(c - a), bc = scaled(c - b);
    const double longest = std::max({squaredLength(ab), squaredLength(ac), squaredLength(bc)});
    return cross(ab, ac) > kFlat * longest;
}

bool FaceGeometry::isInRange(Vec2 uv) const
{
    return (periods_.x > 0.0 || rangeU_.contains(uv.x)) && (periods_.y > 0.0 || rangeV_.contains(uv.y));
}

SurfaceFacts FaceGeometry::factsOf(const SurfacePoint& point, Vec2 uv) const
{
    SurfaceFacts facts;
    facts.parameters = uv;
    facts.position = point.position;
    const double u = squaredLength(point.du) * boundsU_.length() * boundsU_.length();
    const double v = squaredLength(point.dv) * boundsV_.length() * boundsV_.length();
    const auto isPole = [&](double along, double across) {
        return along <= kPoleRatio * kPoleRatio * across ||
               along <= std::min(squaredPoleExtent_, kMostPoleRatio * kMostPoleRatio * across);
    };
    facts.isSingularU = isPole(u, v);
    facts.isSingularV = isPole(v, u);
    if (facts.isSingularU || facts.isSingularV) {
        setFactsOfPole(facts);
        return facts;
    }
    const Vec3 normal = point.normal();
    const double size = length(normal);
    // Derivatives along one line have no normal that could be trusted.
    constexpr double kParallel = 1e-6;
    if (!(size > kParallel * length(point.du) * length(point.dv))) return facts;
    facts.normal = (1.0 / size) * normal;
    if (isPlane_) return facts;
    if (const std::optional<SurfaceCurvature> curvature = curvatureOf(point)) {
        const double largest = std::abs(curvature->largest);
        if (largest > 0.0) facts.curvatureRadius = 1.0 / largest;
    }
    return facts;
}

/// A pole has a normal if the normals beside it agree all around.
void FaceGeometry::setFactsOfPole(SurfaceFacts& facts) const
{
    if (facts.isSingularU && facts.isSingularV) return;
    constexpr int kDirections = 4;
    constexpr double kAgreeing = 0.999;
    Vec3 sum;
    double radius = std::numeric_limits<double>::infinity();
    std::array<Vec3, kDirections> normals;
    for (int i = 0; i < kDirections; ++i) {
        const double around = (i + 0.5) / kDirections;
        Vec2 uv = facts.parameters;
        if (facts.isSingularU) {
            uv = {boundsU_.at(around), uv.y + kBesidePole * (boundsV_.at(0.5) - uv.y)};
        } else {
            uv = {uv.x + kBesidePole * (boundsU_.at(0.5) - uv.x), boundsV_.at(around)};
        }
        const SurfacePoint beside = surface_->evaluate(uv);
        const Vec3 normal = beside.normal();
        const double size = length(normal);
        if (!(size > 0.0)) return;
        normals[static_cast<std::size_t>(i)] = (1.0 / size) * normal;
        sum = sum + normals[static_cast<std::size_t>(i)];
        if (const auto curvature = curvatureOf(beside); curvature && curvature->largest != 0.0) {
            radius = std::min(radius, 1.0 / std::abs(curvature->largest));
        }
    }
    const double size = length(sum);
    if (!(size > 0.0)) return;
    const Vec3 mean = (1.0 / size) * sum;
    for (const Vec3& normal : normals) {
        if (dot(normal, mean) < kAgreeing) return;
    }
    facts.normal = mean;
    facts.curvatureRadius = radius;
}

SurfaceFacts FaceGeometry::at(Vec2 uv) const { return factsOf(surface_->evaluate(uv), uv); }

SurfaceFacts FaceGeometry::projected(const Vec3& point, Vec2 seed) const
{
    return at(surface_->project(point, seed).parameters);
}

SurfaceFacts FaceGeometry::between(Vec2 uvA, const Vec3& a, Vec2 uvB, const Vec3& b) const
{
    constexpr int kMostSteps = 12;
    constexpr double kNearEnough = 1e-3;
    double low = 0.0, high = 1.0, share = 0.5;
    for (int step = 0; step < kMostSteps; ++step, share = 0.5 * (low + high)) {
        const Vec3 p = surface_->position(uvA + share * (uvB - uvA));
        const double toA = length(p - a), toB = length(p - b);
        if (std::abs(toA - toB) <= kNearEnough * (toA + toB)) break;
        (toA < toB ? low : high) = share;
    }
    return at(uvA + share * (uvB - uvA));
}

std::optional<SurfaceBallCentre> FaceGeometry::ballCentre(const Vec3& circumcentre, const Vec3& unitNormal,
                                                          double radius, Vec2 seed) const
{
    if (isPlane_) return SurfaceBallCentre{projected(circumcentre, seed), 0.0};
    constexpr int kMostSteps = 6;
    constexpr double kNearEnough = 0.01;
    Vec2 uv = seed;
    for (int step = 0; step <= kMostSteps; ++step) {
        if (!isInRange(uv)) return {};
        const SurfacePoint p = surface_->evaluate(uv);
        const Vec3 away = p.position - circumcentre;
        const double height = dot(away, unitNormal);
        const Vec3 offAxis = away - height * unitNormal;
        if (squaredLength(offAxis) <= kNearEnough * kNearEnough * radius * radius) {
            if (std::abs(height) > radius) return {};
            return SurfaceBallCentre{factsOf(p, uv), height};
        }
        // The plane of the facet's normal: two equations in the parameters, solved by Cramer's rule.
        const double determinant = dot(cross(p.du, p.dv), unitNormal);
        if (!(std::abs(determinant) > 0.0)) return {};
        const Vec2 move{-dot(cross(offAxis, p.dv), unitNormal) / determinant,
                        -dot(cross(p.du, offAxis), unitNormal) / determinant};
        if (!isFinite(move)) return {};
        uv = uv + move;
    }
    return {};
}

}  // namespace mesher
