#include "surface_sampling/facet_split.h"

#include "predicates/circumcenter.h"
#include "surface_sampling/face_walk.h"
#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mesher {
namespace {

/// Centres are taken whose surface looks away from the facet by no more than 60 degrees.
constexpr double kLeastAgreement = 0.5;
/// How far a projected centre may lie off the perpendicular, in circumradii or lengths of the edge.
constexpr double kMostAside = 0.1;
/// The difference of the halves of an edge, by their sum.
constexpr double kMostUneven = 0.3;

FacetShape shapeOf(const FaceMesh& mesh, TriangleId t)
{
    const FaceTriangle& record = mesh.triangle(t);
    return FacetShape::of(mesh.position(record.v[0]), mesh.position(record.v[1]), mesh.position(record.v[2]));
}

/// Where the circumcentre is in the parameters, if these were linear over the facet.
Vec2 circumcentreParameters(const FaceTriangle& record, const FacetShape& shape)
{
    const auto& s = shape.squaredSide;
    std::array<double, 3> weight{};
    double sum = 0.0;
    for (unsigned i = 0; i < 3; ++i) {
        weight[i] = s[i] * (s[nextCorner(i)] + s[previousCorner(i)] - s[i]);
        sum += weight[i];
    }
    return (1.0 / sum) * (weight[0] * record.uv[0] + weight[1] * record.uv[1] + weight[2] * record.uv[2]);
}

}  // namespace

FacetSplitter::FacetSplitter(FaceMesh& mesh, const FaceGeometry& geometry, const FacetCriteria& criteria,
                             const FacetSplitOptions& options)
    : mesh_(mesh),
      geometry_(geometry),
      criteria_(criteria),
      options_(options),
      encroachmentCosine_(options.encroachmentAngle == 90.0
                              ? 0.0
                              : std::cos(options.encroachmentAngle * std::numbers::pi / 180.0)),
      star_(mesh, geometry)
{
}

FaceVertex FacetSplitter::vertexAt(const SurfaceFacts& facts) const
{
    FaceVertex vertex = FaceVertex::of(facts);
    vertex.size = criteria_.sizeAt(facts.position, facts.curvatureRadius);
    vertex.isFree = true;
    return vertex;
}

bool FacetSplitter::encroaches(const Vec3& point, const Vec3& a, const Vec3& b) const
{
    const double cosine = dot(a - point, b - point);
    if (cosine >= 0.0) return false;
    return encroachmentCosine_ == 0.0 ||
           cosine < encroachmentCosine_ * std::sqrt(squaredLength(a - point) * squaredLength(b - point));
}

/// Around a pole the walk and the projection may have gone different ways, a period apart.
Vec2 FacetSplitter::nearImage(TriangleId t, Vec2 uv) const
{
    const FaceTriangle& record = mesh_.triangle(t);
    Vec2 sum;
    double count = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (mesh_.vertex(record.v[i]).isPole()) continue;
        sum = sum + record.uv[i];
        count += 1.0;
    }
    return count > 0.0 ? uv + geometry_.shiftBetween(uv, (1.0 / count) * sum) : uv;
}

EdgeLink FacetSplitter::nearestSide(TriangleId t, const Vec3& point) const
{
    EdgeLink nearest;
    double least = std::numeric_limits<double>::infinity();
    for (unsigned i = 0; i < 3; ++i) {
        const EdgeLink side(t, i);
        const double distance = sideOfEdge(mesh_, side, point) /
                                length(mesh_.position(mesh_.to(side)) - mesh_.position(mesh_.from(side)));
        if (distance < least) {
            least = distance;
            nearest = side;
        }
    }
    return nearest;
}

/// The least of the corners.
double FacetSplitter::squaredCurvatureRadius(TriangleId t) const
{
    double radius = std::numeric_limits<double>::infinity();
    for (const VertexId v : mesh_.triangle(t).v) radius = std::min(radius, mesh_.vertex(v).curvatureRadius);
    return radius * radius;
}

std::optional<SurfaceFacts> FacetSplitter::findCentre(TriangleId t)
{
    const FaceTriangle& record = mesh_.triangle(t);
    const Vec3 &a = mesh_.position(record.v[0]), &b = mesh_.position(record.v[1]),
               &c = mesh_.position(record.v[2]);
    const FacetShape shape = FacetShape::of(a, b, c);
    const std::optional<Vec3> centre = approximateCircumcenter(a, b, c);
    if (!centre || !std::isfinite(shape.squaredRadius)) return {};
    const double radius = std::sqrt(shape.squaredRadius);
    const Vec3 normal = cross(b - a, c - a);
    const Vec3 unit = (1.0 / length(normal)) * normal;
    const Vec2 seed = circumcentreParameters(record, shape);
    const auto looksAway = [&](const SurfaceFacts& facts) {
        return dot(facts.normal, unit) < kLeastAgreement;
    };
    if (const auto found = geometry_.ballCentre(*centre, unit, radius, seed);
        found && !looksAway(found->facts)) {
        return found->facts;
    }
    ++counts_.projectedCentres;
    const Vec2 inside = (1.0 / 3.0) * (record.uv[0] + record.uv[1] + record.uv[2]);
    const SurfaceFacts facts = geometry_.projected(*centre, inside);
    const Vec3 away = facts.position - *centre;
    if (squaredLength(away) > shape.squaredRadius || looksAway(facts)) return {};
    // At the end of the surface there is no foot of a perpendicular, only a nearest point.
    const Vec3 aside = away - dot(away, facts.normal) * facts.normal;
    if (squaredLength(aside) > kMostAside * kMostAside * shape.squaredRadius) return {};
    return facts;
}

/// The longest side. The middle of that of a flat facet is next to the opposite corner, and the edge between them would be the
/// first of many: then the longest side of the facet behind it, as long as these grow.
/// Reference   [rivara1997]
EdgeLink FacetSplitter::sideToHalve(TriangleId t) const
{
    constexpr int kMostSteps = 20;
    EdgeLink side(t, shapeOf(mesh_, t).longest);
    if (!isFlatFacet(mesh_, t)) return side;
    for (int step = 0; step < kMostSteps && !mesh_.segment(side).isValid(); ++step) {
        const EdgeLink other = mesh_.across(side);
        if (!other.isValid()) break;
        const FacetShape behind = shapeOf(mesh_, other.triangle());
        if (behind.longest == other.edge()) break;
        side = EdgeLink(other.triangle(), behind.longest);
    }
    return side;
}

FacetSplitStatus FacetSplitter::evaluate(TriangleId t, StarExtent extent, FacetNeed need)
{
    encroached_.clear();
    const FacetShape shape = shapeOf(mesh_, t);
    const double curvature = squaredCurvatureRadius(t);
    const bool mayHalve = need == FacetNeed::Size || 4.0 * shape.squaredSide[shape.longest] > curvature;
    // Where the surface bends too much for its facets, the middle of the longest edge is always near.
    const EdgeLink longest = sideToHalve(t);
    const auto halve = [&] {
        return mayHalve ? evaluateMiddleOf(longest, extent) : FacetSplitStatus::NotFound;
    };
    if (need == FacetNeed::Size && shape.squaredRadius > curvature) return evaluateMiddleOf(longest, extent);
    const std::optional<SurfaceFacts> centre = findCentre(t);
    if (!centre) return halve();
    const FaceWalk walk = walkToPoint(mesh_, geometry_, t, centre->position);
    switch (walk.outcome) {
        case FaceWalk::Outcome::Lost: ++counts_.lostWalks; return halve();
        case FaceWalk::Outcome::Blocked:
            encroached_.push_back(mesh_.segment(walk.side));
            return FacetSplitStatus::Encroaches;
        case FaceWalk::Outcome::Inside: break;
    }
    const FaceVertex vertex = vertexAt(*centre);
    const Vec2 uv = nearImage(walk.triangle, centre->parameters - walk.shift);
    star_.evaluateInside(walk.triangle, vertex, uv, extent);
    // Above the edge of a coarse facet a vertex makes a steep one; without that edge it does not.
    if (star_.isFolded()) {
        const EdgeLink side = nearestSide(walk.triangle, vertex.position);
        if (!mesh_.segment(side).isValid()) {
            star_.evaluateOnSide(side, vertex, uv, extent, {});
        }
    }
    const FacetSplitStatus status = judgeStar();
    return status == FacetSplitStatus::NotFound ? halve() : status;
}

FacetSplitStatus FacetSplitter::evaluateSide(EdgeLink side, StarExtent extent)
{
    encroached_.clear();
    const FacetSplitStatus status = evaluateMiddleOf(side, extent);
    const bool isOnlyNear = status == FacetSplitStatus::Encroaches && !mesh_.segment(side).isValid();
    return isOnlyNear ? judgeFacetsOfStar() : status;
}

FacetSplitStatus FacetSplitter::evaluateSteep(TriangleId t, StarExtent extent)
{
    encroached_.clear();
    const EdgeLink side(t, shapeOf(mesh_, t).longest);
    if (mesh_.segment(side).isValid()) return FacetSplitStatus::NotFound;
    const FaceTriangle& record = mesh_.triangle(t);
    const unsigned i = nextCorner(side.edge()), k = previousCorner(side.edge());
    leastAgreement_ = kSteepAgreement;
    FacetSplitStatus status = FacetSplitStatus::NotFound;
    // Near an end facets follow the surface there, however the fold goes on.
    for (const double share : {0.5, 0.25, 0.75, 0.125, 0.875}) {
        const SurfaceFacts facts = geometry_.at(record.uv[i] + share * (record.uv[k] - record.uv[i]));
        star_.evaluateOnSide(side, vertexAt(facts), facts.parameters, extent, {});
        status = judgeStar();
        if (status != FacetSplitStatus::NotFound) break;
    }
    leastAgreement_ = kUprightAgreement;
    if (status == FacetSplitStatus::Ready) ++counts_.steepStars;
    return status;
}

/// The foot of the middle of a side. Where the surface turns sharply the nearest point may be no foot but an end of the surface,
/// or lie near one of the ends: then the point between them.
SurfaceFacts FacetSplitter::middleOnSurface(const FaceTriangle& record, unsigned i, unsigned k) const
{
    const Vec3 &a = mesh_.position(record.v[i]), &b = mesh_.position(record.v[k]);
    const Vec3 middle = 0.5 * (a + b);
    const SurfaceFacts foot = geometry_.projected(middle, 0.5 * (record.uv[i] + record.uv[k]));
    const Vec3 away = foot.position - middle;
    const Vec3 aside = away - dot(away, foot.normal) * foot.normal;
    const bool isFoot = squaredLength(aside) <= kMostAside * kMostAside * squaredLength(b - a);
    const double toA = length(foot.position - a), toB = length(foot.position - b);
    if (isFoot && std::abs(toA - toB) <= kMostUneven * (toA + toB)) return foot;
    return geometry_.between(record.uv[i], a, record.uv[k], b);
}

FacetSplitStatus FacetSplitter::evaluateMiddleOf(EdgeLink side, StarExtent extent)
{
    const FaceTriangle& record = mesh_.triangle(side.triangle());
    if (mesh_.segment(side).isValid()) {
        encroached_.push_back(mesh_.segment(side));
        return FacetSplitStatus::Encroaches;
    }
    ++counts_.splitEdges;
    const unsigned i = nextCorner(side.edge()), k = previousCorner(side.edge());
    const Vec3 middle = 0.5 * (mesh_.position(record.v[i]) + mesh_.position(record.v[k]));
    const SurfaceFacts facts = middleOnSurface(record, i, k);
    if (4.0 * squaredLength(facts.position - middle) >
        squaredLength(mesh_.position(record.v[k]) - mesh_.position(record.v[i]))) {
        return FacetSplitStatus::NotFound;
    }
    star_.evaluateOnSide(side, vertexAt(facts), facts.parameters, extent, {});
    return judgeStar();
}

FacetSplitStatus FacetSplitter::judgeStar()
{
    const Vec3& point = star_.vertex().position;
    if (criteria_.crowdsTip(point)) return FacetSplitStatus::TooSmall;
    for (const TriangleId t : star_.cavity()) {
        if (mesh_.isOfFan(t)) return FacetSplitStatus::TooSmall;
    }
    for (const StarSide& side : star_.sides()) {
        const bool isOnRing = mesh_.isOnRing(side.a, side.b);
        if (!side.segment.isValid() && !isOnRing) continue;
        if (!encroaches(point, mesh_.position(side.a), mesh_.position(side.b))) continue;
        // A side of a ring is not split for what is beside it.
        if (isOnRing) return FacetSplitStatus::TooSmall;
        encroached_.push_back(side.segment);
    }
    return encroached_.empty() ? judgeFacetsOfStar() : FacetSplitStatus::Encroaches;
}

FacetSplitStatus FacetSplitter::judgeFacetsOfStar()
{
    if (star_.isFolded(leastAgreement_)) {
        ++counts_.foldedStars;
        return FacetSplitStatus::NotFound;
    }
    return star_.squaredSpokeLength() < options_.floor * options_.floor ? FacetSplitStatus::TooSmall
                                                                        : FacetSplitStatus::Ready;
}

}  // namespace mesher
