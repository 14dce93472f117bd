#include "surface_sampling/surface_refinement.h"

#include "predicates/circumcenter.h"
#include "surface_sampling/face_walk.h"
#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {
namespace {

/// Centres are taken whose surface looks away from the facet by no more than 60 degrees.
constexpr double kLeastAgreement = 0.5;

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

FaceRefinementCounts& FaceRefinementCounts::operator+=(const FaceRefinementCounts& other)
{
    sizeInsertions += other.sizeInsertions;
    qualityInsertions += other.qualityInsertions;
    boundaryInsertions += other.boundaryInsertions;
    removals += other.removals;
    projectedCentres += other.projectedCentres;
    splitEdges += other.splitEdges;
    lostWalks += other.lostWalks;
    foldedStars += other.foldedStars;
    forcedStars += other.forcedStars;
    deferred += other.deferred;
    leftAtSmallAngles += other.leftAtSmallAngles;
    leftForResolution += other.leftForResolution;
    return *this;
}

FaceRefiner::FaceRefiner(FaceMesh& mesh, const FaceGeometry& geometry, const FaceBoundary& boundary,
                         const FaceRefinementOptions& options)
    : mesh_(mesh),
      geometry_(geometry),
      boundary_(boundary),
      options_(options),
      criteria_(options.criteria),
      encroachmentCosine_(options.encroachmentAngle == 90.0
                              ? 0.0
                              : std::cos(options.encroachmentAngle * std::numbers::pi / 180.0)),
      star_(mesh, geometry),
      removal_(mesh, geometry)
{
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        FaceVertex& vertex = mesh.vertex(VertexId(i));
        vertex.size = criteria_.sizeAt(vertex.position, vertex.curvatureRadius);
        if (vertex.node.isValid()) vertexOf_.insert(vertex.node, VertexId(i));
    }
}

VertexId FaceRefiner::vertexOf(NodeId node) const
{
    const VertexId* known = vertexOf_.find(node);
    return known != nullptr ? *known : VertexId();
}

// ---- what is to be done ----------------------------------------------------------------------------------------------

void FaceRefiner::queueTriangle(TriangleId t)
{
    const FacetVerdict verdict = criteria_.judge(mesh_, t);
    if (verdict.need == FacetNeed::Nothing) return;
    (verdict.need == FacetNeed::Size ? sizeQueue_ : qualityQueue_)
        .push(t, mesh_.triangle(t).generation, verdict.key);
}

void FaceRefiner::queueMade(const std::vector<TriangleId>& made)
{
    for (const TriangleId t : made) queueTriangle(t);
}

void FaceRefiner::queueAll()
{
    sizeQueue_.clear();
    qualityQueue_.clear();
    waiting_.clear();
    for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
        if (!mesh_.triangle(TriangleId(i)).isAlive) continue;
        mesh_.triangle(TriangleId(i)).isLeft = false;
        queueTriangle(TriangleId(i));
    }
}

bool FaceRefiner::propose(SegmentId segment)
{
    if (!boundary_.maySplit(segment)) return false;
    proposals_.push_back(segment);
    return true;
}

std::vector<SegmentId> FaceRefiner::takeProposals()
{
    std::sort(proposals_.begin(), proposals_.end());
    proposals_.erase(std::unique(proposals_.begin(), proposals_.end()), proposals_.end());
    return std::exchange(proposals_, {});
}

bool FaceRefiner::encroaches(const Vec3& point, const Vec3& a, const Vec3& b) const
{
    const double cosine = dot(a - point, b - point);
    if (cosine >= 0.0) return false;
    return encroachmentCosine_ == 0.0 ||
           cosine < encroachmentCosine_ * std::sqrt(squaredLength(a - point) * squaredLength(b - point));
}

void FaceRefiner::proposeIfEncroached(EdgeLink side)
{
    const SegmentId segment = mesh_.segment(side);
    if (!segment.isValid()) return;
    const VertexId apex = mesh_.apex(side);
    if (encroaches(mesh_.position(apex), mesh_.position(mesh_.from(side)), mesh_.position(mesh_.to(side)))) {
        propose(segment);
    }
}

void FaceRefiner::proposeSegments()
{
    for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
        if (!mesh_.triangle(TriangleId(i)).isAlive) continue;
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(TriangleId(i), k);
            if (!mesh_.segment(side).isValid()) continue;
            if (criteria_.isTooLong(mesh_, side)) {
                propose(mesh_.segment(side));
            } else {
                proposeIfEncroached(side);
            }
        }
    }
}

void FaceRefiner::proposeAround(VertexId v)
{
    mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) {
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(opposite.triangle(), k);
            if (mesh_.segment(side).isValid() && criteria_.isTooLong(mesh_, side)) {
                propose(mesh_.segment(side));
            } else {
                proposeIfEncroached(side);
            }
        }
    });
}

// ---- the loop --------------------------------------------------------------------------------------------------------

StopReason FaceRefiner::refine(Budget& budget)
{
    for (const Waiting& waiting : std::exchange(waiting_, {})) {
        const FaceTriangle& record = mesh_.triangle(waiting.triangle);
        if (record.isAlive && record.generation == waiting.generation) queueTriangle(waiting.triangle);
    }
    for (;;) {
        const bool isSize = !sizeQueue_.empty();
        const auto entry = (isSize ? sizeQueue_ : qualityQueue_).pop();
        if (!entry) break;
        const FaceTriangle& record = mesh_.triangle(entry->id);
        if (!record.isAlive || record.generation != entry->generation || record.isLeft) continue;
        const FacetVerdict verdict = criteria_.judge(mesh_, entry->id);
        if (verdict.key != entry->key)
            continue;  // the generation has wrapped: another entry is the right one
        if (!budget.allows({mesh_.vertexCount(), mesh_.triangleCount()})) {
            (isSize ? sizeQueue_ : qualityQueue_).push(entry->id, entry->generation, entry->key);
            break;
        }
        processTriangle(entry->id, verdict.need);
    }
    return budget.stopReason();
}

void FaceRefiner::processTriangle(TriangleId t, FacetNeed need)
{
    if (isAtSmallAngle(t)) {
        mesh_.triangle(t).isLeft = true;
        ++counts_.leftAtSmallAngles;
        return;
    }
    switch (attemptCentre(t)) {
        case Attempt::Inserted:
            ++(need == FacetNeed::Size ? counts_.sizeInsertions : counts_.qualityInsertions);
            break;
        case Attempt::Deferred:
            ++counts_.deferred;
            waiting_.push_back({t, mesh_.triangle(t).generation});
            break;
        case Attempt::Impossible:
            mesh_.triangle(t).isLeft = true;
            ++counts_.leftForResolution;
            break;
    }
}

bool FaceRefiner::isAtSmallAngle(TriangleId t) const
{
    const FaceTriangle& record = mesh_.triangle(t);
    const FacetShape shape =
        FacetShape::of(mesh_.position(record.v[0]), mesh_.position(record.v[1]), mesh_.position(record.v[2]));
    const NodeId a = mesh_.vertex(record.v[nextCorner(shape.shortest)]).node;
    const NodeId b = mesh_.vertex(record.v[previousCorner(shape.shortest)]).node;
    return a.isValid() && b.isValid() && boundary_.spansSmallAngle(a, b);
}

// ---- a new vertex inside ---------------------------------------------------------------------------------------------

FaceVertex FaceRefiner::freeVertex(const SurfaceFacts& facts) const
{
    FaceVertex vertex = FaceVertex::of(facts);
    vertex.size = criteria_.sizeAt(facts.position, facts.curvatureRadius);
    vertex.isFree = true;
    return vertex;
}

std::optional<SurfaceFacts> FaceRefiner::findCentre(TriangleId t)
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
    if (squaredLength(facts.position - *centre) > shape.squaredRadius || looksAway(facts)) return {};
    return facts;
}

FaceRefiner::Attempt FaceRefiner::attemptCentre(TriangleId t)
{
    const std::optional<SurfaceFacts> centre = findCentre(t);
    if (!centre) return attemptLongestEdge(t);
    const FaceWalk walk = walkToPoint(mesh_, geometry_, t, centre->position);
    switch (walk.outcome) {
        case FaceWalk::Outcome::Lost: ++counts_.lostWalks; return attemptLongestEdge(t);
        case FaceWalk::Outcome::Blocked:
            return propose(mesh_.segment(walk.side)) ? Attempt::Deferred : Attempt::Impossible;
        case FaceWalk::Outcome::Inside: break;
    }
    star_.evaluateInside(walk.triangle, freeVertex(*centre), centre->parameters - walk.shift,
                         StarExtent::Delaunay);
    if (star_.isFolded()) return attemptLongestEdge(t);
    return finish();
}

/// Where the surface bends too much for its facets, the middle of the longest edge is always near.
FaceRefiner::Attempt FaceRefiner::attemptLongestEdge(TriangleId t)
{
    const FaceTriangle& record = mesh_.triangle(t);
    const FacetShape shape =
        FacetShape::of(mesh_.position(record.v[0]), mesh_.position(record.v[1]), mesh_.position(record.v[2]));
    const EdgeLink side(t, shape.longest);
    if (mesh_.segment(side).isValid()) {
        return propose(mesh_.segment(side)) ? Attempt::Deferred : Attempt::Impossible;
    }
    ++counts_.splitEdges;
    const unsigned i = nextCorner(side.edge()), k = previousCorner(side.edge());
    const Vec3 middle = 0.5 * (mesh_.position(record.v[i]) + mesh_.position(record.v[k]));
    const SurfaceFacts facts = geometry_.projected(middle, 0.5 * (record.uv[i] + record.uv[k]));
    if (4.0 * squaredLength(facts.position - middle) > shape.squaredSide[shape.longest])
        return Attempt::Impossible;
    star_.evaluateOnSide(side, freeVertex(facts), facts.parameters, StarExtent::Delaunay, {});
    if (star_.isFolded()) {
        ++counts_.foldedStars;
        return Attempt::Impossible;
    }
    return finish();
}

FaceRefiner::Attempt FaceRefiner::proposeEncroached()
{
    bool isEncroaching = false, isProposed = false;
    const Vec3& point = star_.vertex().position;
    for (const StarSide& side : star_.sides()) {
        if (!side.segment.isValid()) continue;
        if (!encroaches(point, mesh_.position(side.a), mesh_.position(side.b))) continue;
        isEncroaching = true;
        isProposed = propose(side.segment) || isProposed;
    }
    if (!isEncroaching) return Attempt::Inserted;
    return isProposed ? Attempt::Deferred : Attempt::Impossible;
}

/// Makes the star, unless it encroaches on a segment or is too small.
FaceRefiner::Attempt FaceRefiner::finish()
{
    if (const Attempt outcome = proposeEncroached(); outcome != Attempt::Inserted) return outcome;
    if (star_.squaredSpokeLength() < options_.floor * options_.floor) return Attempt::Impossible;
    star_.commit();
    queueMade(star_.made());
    return Attempt::Inserted;
}

// ---- segments --------------------------------------------------------------------------------------------------------

EdgeLink FaceRefiner::sideOf(const SegmentVertex& split) const
{
    const VertexId a = vertexOf(split.ends[0]), b = vertexOf(split.ends[1]);
    if (!a.isValid() || !b.isValid()) return {};
    for (const EdgeLink side : {mesh_.findSide(a, b), mesh_.findSide(b, a)}) {
        if (side.isValid() && mesh_.segment(side) == split.segment) return side;
    }
    return {};
}

/// Chew's rule: free vertices in the ball of a segment that is split give way.
bool FaceRefiner::removeApex(EdgeLink side)
{
    const VertexId apex = mesh_.apex(side);
    if (!mesh_.vertex(apex).isFree) return false;
    const Vec3& p = mesh_.position(apex);
    if (dot(mesh_.position(mesh_.from(side)) - p, mesh_.position(mesh_.to(side)) - p) >= 0.0) return false;
    if (!removal_.evaluate(apex)) return false;
    removal_.commit();
    ++counts_.removals;
    queueMade(removal_.made());
    return true;
}

void FaceRefiner::insertOnSegment(const SegmentVertex& split)
{
    EdgeLink side = sideOf(split);
    while (side.isValid() && removeApex(side)) side = sideOf(split);
    while (side.isValid() && mesh_.across(side).isValid() && removeApex(mesh_.across(side)))
        side = sideOf(split);
    if (!side.isValid()) return;
    const FaceTriangle& record = mesh_.triangle(side.triangle());
    const VertexId from = mesh_.from(side), to = mesh_.to(side);
    const double before = length(split.position - mesh_.position(from));
    const double after = length(split.position - mesh_.position(to));
    const double share = before + after > 0.0 ? before / (before + after) : 0.5;
    const Vec2 uvFrom = record.uv[nextCorner(side.edge())], uvTo = record.uv[previousCorner(side.edge())];
    const SurfaceFacts facts = geometry_.projected(split.position, uvFrom + share * (uvTo - uvFrom));
    FaceVertex vertex = freeVertex(facts);
    vertex.isFree = false;
    vertex.position = split.position;
    vertex.node = split.node;
    const bool isAlong = mesh_.vertex(from).node == split.ends[0];
    const std::array<SegmentId, 2> halves =
        isAlong ? split.halves : std::array<SegmentId, 2>{split.halves[1], split.halves[0]};
    star_.evaluateOnSide(side, vertex, facts.parameters, StarExtent::Delaunay, halves);
    if (star_.isFolded()) {
        ++counts_.forcedStars;
        star_.evaluateOnSide(side, vertex, facts.parameters, StarExtent::Least, halves);
    }
    const VertexId v = star_.commit();
    vertexOf_.insert(split.node, v);
    ++counts_.boundaryInsertions;
    queueMade(star_.made());
    proposeAround(v);
}

}  // namespace mesher
