#include "surface_sampling/surface_refinement.h"

#include "surface_sampling/face_flips.h"
#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mesher {
namespace {

/// Far more than a vertex of a sound mesh needs.
constexpr std::size_t kMostFlipsAround = 200;

}  // namespace

FaceRefinementCounts& FaceRefinementCounts::operator+=(const FaceRefinementCounts& other)
{
    sizeInsertions += other.sizeInsertions;
    qualityInsertions += other.qualityInsertions;
    boundaryInsertions += other.boundaryInsertions;
    removals += other.removals;
    splits.projectedCentres += other.splits.projectedCentres;
    splits.splitEdges += other.splits.splitEdges;
    splits.lostWalks += other.splits.lostWalks;
    splits.foldedStars += other.splits.foldedStars;
    splits.steepStars += other.splits.steepStars;
    forcedStars += other.forcedStars;
    lostSegments += other.lostSegments;
    deferred += other.deferred;
    leftAtSmallAngles += other.leftAtSmallAngles;
    leftForResolution += other.leftForResolution;
    leftOnRims += other.leftOnRims;
    leftOnStrips += other.leftOnStrips;
    releasedFans += other.releasedFans;
    return *this;
}

FaceRefiner::FaceRefiner(FaceMesh& mesh, const FaceGeometry& geometry, const FaceBoundary& boundary,
                         const FaceRefinementOptions& options)
    : mesh_(mesh),
      geometry_(geometry),
      boundary_(boundary),
      criteria_(options.criteria),
      floor_(options.splits.floor),
      splitter_(mesh, geometry, criteria_, options.splits),
      removal_(mesh, geometry),
      isWatched_(criteria_.minAngle() > FacetCriteriaOptions{}.minAngle)
{
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        FaceVertex& vertex = mesh.vertex(VertexId(i));
        vertex.size = criteria_.sizeAt(vertex.position, vertex.curvatureRadius);
        if (vertex.node.isValid()) setVertexOf(vertex.node, VertexId(i));
    }
}

FaceRefinementCounts FaceRefiner::counts() const
{
    FaceRefinementCounts counts = counts_;
    counts.splits = splitter_.counts();
    for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
        const FaceTriangle& record = mesh_.triangle(TriangleId(i));
        if (!record.isAlive) continue;
        counts.leftAtSmallAngles += record.left == FacetLeft::SmallAngle ? 1 : 0;
        counts.leftOnRims += record.left == FacetLeft::Rim ? 1 : 0;
        counts.leftOnStrips += record.left == FacetLeft::Strip ? 1 : 0;
        counts.leftForResolution += record.left == FacetLeft::Resolution ? 1 : 0;
    }
    return counts;
}

void FaceRefiner::setVertexOf(NodeId node, VertexId v)
{
    verticesOf_[node].push_back(v);
    ++boundVertices_;
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
        mesh_.triangle(TriangleId(i)).left = FacetLeft::No;
        queueTriangle(TriangleId(i));
    }
}

bool FaceRefiner::queueGivenUp(RunContext& context)
{
    if (!std::exchange(hasGivenUp_, false)) return false;
    // Among coarse facets, edges could not be flipped without a fold, that can be now; a fan of needles at one node may stay else.
    Budget budget(flipLimits(mesh_), context);
    const bool isChanged = makeSurfaceDelaunay(mesh_, geometry_, budget).flips > 0;
    bool isAny = false;
    isTryingAgain_ = true;
    for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
        FaceTriangle& record = mesh_.triangle(TriangleId(i));
        if (!record.isAlive) continue;
        const bool isGivenUp = record.left == FacetLeft::Resolution;
        if (isGivenUp) record.left = FacetLeft::No;
        if (isGivenUp || isChanged) queueTriangle(TriangleId(i));
        isAny = isAny || isGivenUp || isChanged;
    }
    return isAny;
}

void FaceRefiner::force(TriangleId t)
{
    if (mesh_.isOfFan(t)) {
        mesh_.releaseFan(t);
        ++counts_.releasedFans;
    }
    mesh_.triangle(t).isForced = true;
    mesh_.triangle(t).left = FacetLeft::No;
    queueTriangle(t);
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

void FaceRefiner::proposeIfEncroached(EdgeLink side)
{
    // Across a rim each segment that is longer than the rim is wide has the other side's nodes in its ball.
    if (rimPlaceAt(side)) return;
    const Vec3& p = mesh_.position(mesh_.apex(side));
    const Vec3 &a = mesh_.position(mesh_.from(side)), &b = mesh_.position(mesh_.to(side));
    if (!splitter_.encroaches(p, a, b)) return;
    // What is nearer than the floor could not be told from the segment by any number of splits.
    const double height2 = squaredLength(cross(b - a, p - a));
    if (height2 >= floor_ * floor_ * squaredLength(b - a)) propose(mesh_.segment(side));
}

/// If it is a segment that is too long, or encroached.
void FaceRefiner::proposeIfNeeded(EdgeLink side)
{
    if (!mesh_.segment(side).isValid() || mesh_.isSpoke(side)) return;
    if (isTooLong(side)) {
        propose(mesh_.segment(side));
    } else {
        proposeIfEncroached(side);
    }
}

void FaceRefiner::proposeSegments()
{
    for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
        if (!mesh_.triangle(TriangleId(i)).isAlive) continue;
        for (unsigned k = 0; k < 3; ++k) proposeIfNeeded(EdgeLink(TriangleId(i), k));
    }
}

void FaceRefiner::proposeAround(VertexId v)
{
    mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) {
        for (unsigned k = 0; k < 3; ++k) proposeIfNeeded(EdgeLink(opposite.triangle(), k));
    });
}

// ---- the loop --------------------------------------------------------------------------------------------------------

void FaceRefiner::queueWaiting()
{
    for (const Waiting& waiting : std::exchange(waiting_, {})) {
        const FaceTriangle& record = mesh_.triangle(waiting.triangle);
        if (record.isAlive && record.generation == waiting.generation) queueTriangle(waiting.triangle);
    }
}

StopReason FaceRefiner::refine(Budget& budget)
{
    for (;;) {
        const bool isSize = !sizeQueue_.empty();
        const auto entry = (isSize ? sizeQueue_ : qualityQueue_).pop();
        if (!entry) break;
        const FaceTriangle& record = mesh_.triangle(entry->id);
        if (!record.isAlive || record.generation != entry->generation || record.left != FacetLeft::No)
            continue;
        const FacetVerdict verdict = criteria_.judge(mesh_, entry->id);
        if (verdict.key != entry->key)
            continue;  // the generation has wrapped: another entry is the right one
        if (!budget.allows({mesh_.vertexCount(), mesh_.triangleCount()})) {
            (isSize ? sizeQueue_ : qualityQueue_).push(entry->id, entry->generation, entry->key);
            break;
        }
        if (verdict.need == FacetNeed::Quality && isWatched_) watchBacklog();
        processTriangle(entry->id, verdict.need);
    }
    return budget.stopReason();
}

/// Gives an angle up that more vertices do not bring nearer.
void FaceRefiner::watchBacklog()
{
    if (!backlog_.isDue(mesh_.vertexCount())) return;
    std::uint64_t bad = 0;
    for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
        const FaceTriangle& record = mesh_.triangle(TriangleId(i));
        if (!record.isAlive || record.left != FacetLeft::No) continue;
        if (criteria_.judge(mesh_, TriangleId(i)).need == FacetNeed::Quality) ++bad;
    }
    if (!backlog_.look(mesh_.vertexCount(), bad)) return;
    criteria_.setMinAngle(FacetCriteriaOptions{}.minAngle);
    isWatched_ = false;
    hasGivenUpAngle_ = true;
}

void FaceRefiner::processTriangle(TriangleId t, FacetNeed need)
{
    const FaceTriangle& record = mesh_.triangle(t);
    const FacetShape shape =
        FacetShape::of(mesh_.position(record.v[0]), mesh_.position(record.v[1]), mesh_.position(record.v[2]));
    if (!record.isForced && leaveOnRim(t)) return;
    const bool isLocked = mesh_.isOfFan(t) || isAtSmallAngle(record, shape);
    if (isLocked && !record.isForced) {
        mesh_.triangle(t).left = FacetLeft::SmallAngle;
        return;
    }
    // Good facets there would have edges below the floor: slivers of the model are left as they are.
    if (need == FacetNeed::Quality && shape.squaredSide[shape.shortest] < floor_ * floor_) {
        mesh_.triangle(t).left = FacetLeft::Resolution;
        return;
    }
    // Two faces in one small angle must not have the same facet there: one of them gets a vertex on the shell.
    FacetSplitStatus status = isLocked
                                  ? splitter_.evaluateSide(EdgeLink(t, shape.shortest), StarExtent::Delaunay)
                                  : splitter_.evaluate(t, StarExtent::Delaunay, need);
    // Not at once: what is around a facet that bridges a fold mostly gives way to it.
    if (status == FacetSplitStatus::NotFound && isTryingAgain_ && criteria_.hidesSurface(mesh_, t))
        status = splitter_.evaluateSteep(t, StarExtent::Delaunay);
    if (status == FacetSplitStatus::Ready) {
        const std::uint16_t generation = record.generation;
        const VertexId v = splitter_.star().commit();
        mesh_.vertex(v).isOnShell = isLocked;
        queueMade(splitter_.star().made());
        // It may have been a facet behind it that was split.
        const FaceTriangle& left = mesh_.triangle(t);
        if (left.isAlive && left.generation == generation) queueTriangle(t);
        ++(need == FacetNeed::Size ? counts_.sizeInsertions : counts_.qualityInsertions);
        return;
    }
    bool isProposed = false, isAtApex = false;
    if (status == FacetSplitStatus::Encroaches) {
        for (const SegmentId segment : splitter_.encroached()) {
            if (need == FacetNeed::Quality && boundary_.isAtApex(segment)) {
                isAtApex = true;
            } else {
                isProposed = propose(segment) || isProposed;
            }
        }
    }
    if (isAtApex && !isProposed) {
        mesh_.triangle(t).left = FacetLeft::SmallAngle;
    } else if (isProposed) {
        ++counts_.deferred;
        waiting_.push_back({t, mesh_.triangle(t).generation});
    } else {
        mesh_.triangle(t).left = FacetLeft::Resolution;
        hasGivenUp_ = true;
    }
}

bool FaceRefiner::isAtSmallAngle(const FaceTriangle& record, const FacetShape& shape) const
{
    const FaceVertex& first = mesh_.vertex(record.v[nextCorner(shape.shortest)]);
    const FaceVertex& last = mesh_.vertex(record.v[previousCorner(shape.shortest)]);
    if (first.isOnShell || last.isOnShell) {
        const FaceVertex& apex = mesh_.vertex(record.v[shape.shortest]);
        return !apex.isFree && (first.isOnShell || !first.isFree) && (last.isOnShell || !last.isFree);
    }
    return !first.isFree && !last.isFree && boundary_.spansSmallAngle(first.node, last.node);
}

// ---- segments --------------------------------------------------------------------------------------------------------

EdgeLink FaceRefiner::sideOf(const SegmentVertex& split) const
{
    const auto* first = verticesOf_.find(split.ends[0]);
    const auto* last = verticesOf_.find(split.ends[1]);
    if (first == nullptr || last == nullptr) return {};
    for (const VertexId a : *first) {
        for (const VertexId b : *last) {
            for (const EdgeLink side : {mesh_.findSide(a, b), mesh_.findSide(b, a)}) {
                if (side.isValid() && mesh_.segment(side) == split.segment) return side;
            }
        }
    }
    return {};
}

bool FaceRefiner::isSpoke(const std::array<NodeId, 2>& ends) const
{
    const auto* first = verticesOf_.find(ends[0]);
    const auto* last = verticesOf_.find(ends[1]);
    if (first == nullptr || last == nullptr) return false;
    return std::any_of(first->begin(), first->end(), [&](VertexId a) {
        return std::any_of(last->begin(), last->end(), [&](VertexId b) { return mesh_.isSpoke(a, b); });
    });
}

/// Chew's rule: free vertices in the ball of a segment that is split give way.
bool FaceRefiner::removeApex(EdgeLink side)
{
    const VertexId apex = mesh_.apex(side);
    if (!mesh_.vertex(apex).isFree || mesh_.vertex(apex).isOnRing) return false;
    const Vec3& p = mesh_.position(apex);
    if (dot(mesh_.position(mesh_.from(side)) - p, mesh_.position(mesh_.to(side)) - p) >= 0.0) return false;
    if (!removal_.evaluate(apex)) return false;
    removal_.commit();
    ++counts_.removals;
    queueMade(removal_.made());
    return true;
}

SurfaceFacts FaceRefiner::factsOnSide(EdgeLink side, const Vec3& position) const
{
    const FaceTriangle& record = mesh_.triangle(side.triangle());
    const double before = length(position - mesh_.position(mesh_.from(side)));
    const double after = length(position - mesh_.position(mesh_.to(side)));
    const double share = before + after > 0.0 ? before / (before + after) : 0.5;
    const Vec2 from = record.uv[nextCorner(side.edge())], to = record.uv[previousCorner(side.edge())];
    return geometry_.projected(position, from + share * (to - from));
}

void FaceRefiner::evaluateOnSide(EdgeLink side, const SegmentVertex& split, StarExtent extent)
{
    const SurfaceFacts facts = factsOnSide(side, split.position);
    FaceVertex vertex = splitter_.vertexAt(facts);
    vertex.isFree = false;
    vertex.position = split.position;
    vertex.node = split.node;
    std::optional<Vec2> uvBehind;
    if (const EdgeLink other = mesh_.across(side); other.isValid()) {
        const SurfaceFacts behind = factsOnSide(other, split.position);
        uvBehind = behind.parameters;
        vertex.keepNormal(behind.normal);
    }
    const bool isAlong = mesh_.vertex(mesh_.from(side)).node == split.ends[0];
    const std::array<SegmentId, 2> halves =
        isAlong ? split.halves : std::array<SegmentId, 2>{split.halves[1], split.halves[0]};
    FaceStar& star = splitter_.star();
    star.evaluateOnSide(side, vertex, facts.parameters, extent, halves, uvBehind);
    if (extent == StarExtent::Least || !star.isFolded()) return;
    ++counts_.forcedStars;
    star.evaluateOnSide(side, vertex, facts.parameters, StarExtent::Least, halves, uvBehind);
}

bool FaceRefiner::evaluateOnSegment(const SegmentVertex& split, StarExtent extent)
{
    const EdgeLink side = sideOf(split);
    if (side.isValid()) evaluateOnSide(side, split, extent);
    return side.isValid();
}

/// The star of a vertex that could not be made Delaunay at once: edge by edge, as far as no facet folds.
void FaceRefiner::flipAround(VertexId v)
{
    std::vector<EdgeLink> suspects;
    mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) { suspects.push_back(opposite); });
    for (std::size_t flips = 0; !suspects.empty() && flips < kMostFlipsAround;) {
        const EdgeLink side = suspects.back();
        suspects.pop_back();
        if (isLocallyDelaunay(mesh_, side) || obstacleToFlip(mesh_, geometry_, side) != FlipObstacle::None)
            continue;
        const EdgeLink diagonal = flip(mesh_, geometry_, side);
        ++flips;
        for (const EdgeLink half : {diagonal, mesh_.across(diagonal)}) {
            suspects.emplace_back(half.triangle(), 1u);
            suspects.emplace_back(half.triangle(), 2u);
            queueTriangle(half.triangle());
        }
    }
}

void FaceRefiner::insertOnSegment(const SegmentVertex& split)
{
    EdgeLink side = sideOf(split);
    while (side.isValid() && removeApex(side)) side = sideOf(split);
    while (side.isValid() && mesh_.across(side).isValid() && removeApex(mesh_.across(side)))
        side = sideOf(split);
    if (!side.isValid()) {
        ++counts_.lostSegments;
        return;
    }
    evaluateOnSide(side, split, StarExtent::Delaunay);
    const std::size_t forcedBefore = counts_.forcedStars;
    const VertexId v = splitter_.star().commit();
    setVertexOf(split.node, v);
    ++counts_.boundaryInsertions;
    if (counts_.forcedStars != forcedBefore) flipAround(v);
    mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) { queueTriangle(opposite.triangle()); });
    proposeAround(v);
}

}  // namespace mesher
