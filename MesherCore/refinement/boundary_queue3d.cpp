#include "refinement/boundary_queue3d.h"

#include "refinement/encroachment3d.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

bool isRefused(const std::vector<char>& refused, std::uint32_t id)
{
    return id < refused.size() && refused[id] != 0;
}

void refuse(std::vector<char>& refused, std::uint32_t id)
{
    if (refused.size() <= id) refused.resize(id + id / 2 + 16, 0);
    refused[id] = 1;
}

}  // namespace

BoundaryQueue3d::BoundaryQueue3d(RefinementState3d& state, BadTetQueue& badTets)
    : state_(state),
      badTets_(badTets),
      splitter_(state.t, state.splitter),
      gaps_(state.t, state.splitter.mesh(), state.options.leastGap)
{
}

void BoundaryQueue3d::pushSegments()
{
    const SurfaceMesh& surface = state_.splitter.mesh();
    for (std::uint32_t i = 0; i < surface.segments.size(); ++i) {
        if (surface.segments[SegmentId(i)].isAlive() && isTooLong(SegmentId(i))) pushSegment(SegmentId(i));
    }
    for (std::uint32_t i = 0; i < state_.mesh.tetLimit(); ++i) {
        if ((state_.mesh.flags(TetId(i)) & tet_flag::kEdges) != 0) pushEncroachedAt(TetId(i));
    }
    facets_.clear();
}

void BoundaryQueue3d::pushFacets()
{
    const SurfaceMesh& surface = state_.splitter.mesh();
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        if (surface.facets[FacetId(i)].isAlive() && state_.isTooLarge(state_.cornersOf(FacetId(i))))
            pushFacet(FacetId(i));
    }
    for (std::uint32_t i = 0; i < state_.mesh.tetLimit(); ++i) pushEncroachedAt(TetId(i));
}

bool BoundaryQueue3d::pushSegment(SegmentId segment)
{
    if (state_.options.boundary == BoundaryPolicy::Frozen || isRefused(refusedSegments_, segment.value))
        return false;
    const auto& ends = state_.splitter.mesh().segments[segment].node;
    const Vec3 along =
        state_.mesh.position(state_.t.vertexOf[ends[1]]) - state_.mesh.position(state_.t.vertexOf[ends[0]]);
    segments_.push(segment, 0, length(along) / state_.t.scale);
    return true;
}

bool BoundaryQueue3d::pushFacet(FacetId facet)
{
    if (state_.options.boundary == BoundaryPolicy::Frozen || isRefused(refusedFacets_, facet.value))
        return false;
    const std::optional<ProtectingBall> ball = ballOf(facet);
    if (!ball) return false;
    facets_.push(facet, 0, std::sqrt(ball->squaredRadius) / state_.t.scale);
    return true;
}

bool BoundaryQueue3d::pushFacetAt(TetFace face)
{
    const FacetId* facet = state_.facetAt(face);
    return facet != nullptr && pushFacet(*facet);
}

std::optional<ProtectingBall> BoundaryQueue3d::ballOf(FacetId facet) const
{
    const auto [a, b, c] = state_.cornersOf(facet);
    return ProtectingBall::ofFacet(state_.mesh.position(a), state_.mesh.position(b), state_.mesh.position(c));
}

bool BoundaryQueue3d::isTooLong(SegmentId segment) const
{
    const auto& ends = state_.splitter.mesh().segments[segment].node;
    return state_.isTooLong(state_.t.vertexOf[ends[0]], state_.t.vertexOf[ends[1]]);
}

void BoundaryQueue3d::pushEncroachedAt(TetId tet)
{
    const Triangulation3d& mesh = state_.mesh;
    if (!state_.isMeshed(tet) || (mesh.flags(tet) & tet_flag::kConstraints) == 0) return;
    if (state_.isLeftFlat(tet)) return;
    for (int face = 0; face < 4; ++face) {
        if (!mesh.isFaceConstrained({tet, face})) continue;
        const auto [a, b, c] = mesh.faceVertices({tet, face});
        const auto ball = ProtectingBall::ofFacet(mesh.position(a), mesh.position(b), mesh.position(c));
        if (!ball || !ball->contains(mesh.position(mesh.vertex(tet, face)))) continue;
        if (!state_.isBesideSmallAngle(std::array{a, b, c})) pushFacetAt({tet, face});
    }
    for (int edge = 0; edge < 6; ++edge) {
        if (!mesh.isEdgeConstrained(tet, edge)) continue;
        const VertexId a = mesh.vertex(tet, kEdgeSlots[edge][0]);
        const VertexId b = mesh.vertex(tet, kEdgeSlots[edge][1]);
        const ProtectingBall ball = ProtectingBall::ofSegment(mesh.position(a), mesh.position(b));
        const bool isEncroached =
            std::any_of(mesh.tet(tet).vertex.begin(), mesh.tet(tet).vertex.end(),
                        [&](VertexId v) { return v != a && v != b && ball.contains(mesh.position(v)); });
        const SegmentId* segment = isEncroached ? state_.segmentAt(a, b) : nullptr;
        if (segment != nullptr) pushSegment(*segment);
    }
}

void BoundaryQueue3d::forgetRefusals()
{
    refusedSegments_.clear();
    refusedFacets_.clear();
    deferredFacets_.clear();
}

void BoundaryQueue3d::serveNext()
{
    if (!segments_.empty()) {
        serveSegment();
    } else {
        serveFacet();
    }
}

void BoundaryQueue3d::serveSegment()
{
    const SegmentId segment = segments_.pop()->id;
    const SurfaceSegment whole = state_.splitter.mesh().segments[segment];
    if (!whole.isAlive() || isRefused(refusedSegments_, segment.value)) return;
    const VertexId a = state_.t.vertexOf[whole.node[0]];
    const VertexId b = state_.t.vertexOf[whole.node[1]];
    const double span = length(state_.mesh.position(b) - state_.mesh.position(a));
    const bool maySplit = state_.maySplit(a, b) && state_.walls.maySplit(std::array{a, b}, span) &&
                          state_.strips.maySplit(std::array{a, b}, span);
    const bool isAllowed =
        (state_.isTooLong(a, b) || (maySplit && !gaps_.isBeside(segment))) && span > 2.0 * floor();
    if (isAllowed) {
        const BoundarySplit3d split = splitter_.splitSegment(segment);
        if (split.outcome == SplitOutcome3d::Split) {
            ++state_.counts.segmentSplits;
            state_.ledger.charge({1, whole.edge.value});
            finishSplit(split);
            return;
        }
    }
    refuse(refusedSegments_, segment.value);
    ++state_.counts.refusedSegments;
    state_.ledger.charge(state_.entityOf(segment));
}

void BoundaryQueue3d::serveFacet()
{
    const FacetId facet = facets_.pop()->id;
    if (!state_.splitter.mesh().facets[facet].isAlive() || isRefused(refusedFacets_, facet.value)) return;
    const auto corners = state_.cornersOf(facet);
    const std::optional<ProtectingBall> ball = ballOf(facet);
    const auto maySplit = [&] {
        return state_.maySplit(corners) && !gaps_.isInside(corners) &&
               state_.walls.maySplit(corners, 2.0 * std::sqrt(ball->squaredRadius)) &&
               state_.strips.maySplit(corners, 2.0 * std::sqrt(ball->squaredRadius));
    };
    const bool isAllowed =
        ball && (state_.isTooLarge(corners) || maySplit()) && ball->squaredRadius > floor() * floor();
    const EntityRef entity = state_.entityOf(facet);
    const bool isServed = isAllowed && trySplit(facet);
    // Splits are charged too: the vertices that they make stand against it, not those that come and go.
    state_.ledger.charge(entity);
    if (isServed) return;
    refuse(refusedFacets_, facet.value);
    ++state_.counts.refusedFacets;
}

/// False if nothing can be done for it.
bool BoundaryQueue3d::trySplit(FacetId facet)
{
    const auto mayEncroach = [&](SegmentId s) { return isRefused(refusedSegments_, s.value); };
    const BoundarySplit3d split = splitter_.splitFacet(facet, mayEncroach);
    switch (split.outcome) {
        case SplitOutcome3d::Split:
            ++state_.counts.facetSplits;
            finishSplit(split);
            return true;
        case SplitOutcome3d::EncroachesSegment:
            // The facet comes again, if it is still there.
            return pushSegment(split.encroached) && pushFacet(facet);
        case SplitOutcome3d::TooSmall: return false;
        case SplitOutcome3d::NotFound:
        case SplitOutcome3d::NotStarShaped: return splitLongestSide(facet);
    }
    return false;
}

/// The segment that is its longest side, or the facet behind that side, in the place of the facet.
bool BoundaryQueue3d::splitLongestSide(FacetId facet)
{
    const auto corner = state_.cornersOf(facet);
    unsigned longest = 0;
    const auto squaredSide = [&](unsigned k) {
        return squaredLength(state_.mesh.position(corner[(k + 1) % 3]) - state_.mesh.position(corner[k]));
    };
    for (unsigned k = 1; k < 3; ++k) {
        if (squaredSide(k) > squaredSide(longest)) longest = k;
    }
    const VertexId from = corner[longest];
    const VertexId to = corner[(longest + 1) % 3];
    // Once only, or two facets could wait for each other.
    if (isRefused(deferredFacets_, facet.value)) return false;
    refuse(deferredFacets_, facet.value);
    const SegmentId* segment = state_.segmentAt(from, to);
    const bool isWaiting =
        segment != nullptr ? pushSegment(*segment) : pushFacet(facetBehind(facet, from, to));
    if (!isWaiting) return false;
    ++state_.counts.neighbourSplits;
    return pushFacet(facet);
}

/// The other facet at a side, which is no segment; invalid if there is none.
FacetId BoundaryQueue3d::facetBehind(FacetId facet, VertexId from, VertexId to)
{
    const Triangulation3d& mesh = state_.mesh;
    const TetId at = mesh.findEdge(from, to);
    if (!at.isValid()) return {};
    mesh.collectEdgeRing(at, from, to, ring_);
    for (const TetId tet : ring_) {
        for (int face = 0; face < 4; ++face) {
            if (!mesh.isFaceConstrained({tet, face})) continue;
            const auto corners = mesh.faceVertices({tet, face});
            const bool isAtSide = std::count(corners.begin(), corners.end(), from) +
                                      std::count(corners.begin(), corners.end(), to) ==
                                  2;
            const FacetId* other = isAtSide ? state_.facetAt({tet, face}) : nullptr;
            if (other != nullptr && *other != facet) return *other;
        }
    }
    return {};
}

void BoundaryQueue3d::finishSplit(const BoundarySplit3d& split)
{
    const VertexId v = split.vertex;
    const bool isLow = state_.scale.assign(v, state_.t.delaunay->neighboursOfCommitted(), ceilingAt(split));
    state_.walls.assign(v, split.surround);
    state_.strips.assign(v, split.surround);
    const SurfaceSplitResult& made = splitter_.made();
    for (const SegmentId half : made.halves) {
        if (half.isValid() && isTooLong(half)) pushSegment(half);
    }
    for (const FacetId facet : made.added) {
        if (state_.isTooLarge(state_.cornersOf(facet))) pushFacet(facet);
    }
    // The cavity need not be that of the Delaunay property alone: its surface had to keep, and to give way, as the facets do.
    const std::vector<TetId>& flipped = state_.flipAround(splitter_.created());
    pushNew(splitter_.created());
    pushNew(flipped);
    if (isLow) badTets_.gradeAround(v);
}

void BoundaryQueue3d::pushNew(std::span<const TetId> created)
{
    for (const TetId tet : created) {
        if (!state_.isMeshed(tet)) continue;
        pushEncroachedAt(tet);
        badTets_.push(tet);
    }
}

/// Mean of the scales of the vertices around, weighted by the inverse of their distance (thesis section 4.4). Between
/// the ends of a segment that is linear interpolation.
double BoundaryQueue3d::ceilingAt(const BoundarySplit3d& split) const
{
    double weights = 0.0;
    double sizes = 0.0;
    for (const VertexId w : split.surround) {
        const double weight = 1.0 / length(state_.mesh.position(w) - state_.mesh.position(split.vertex));
        weights += weight;
        sizes += weight * state_.scale.size(w);
    }
    return sizes / weights;
}

}  // namespace mesher
