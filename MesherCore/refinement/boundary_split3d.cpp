#include "refinement/boundary_split3d.h"

#include <algorithm>

namespace mesher {

namespace {

std::array<VertexId, 2> ascending(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

/// The ends of an added facet that are there already.
std::array<NodeId, 2> oldCorners(const SurfaceFacet& facet)
{
    if (!facet.node[0].isValid()) return {facet.node[1], facet.node[2]};
    if (!facet.node[1].isValid()) return {facet.node[2], facet.node[0]};
    return {facet.node[0], facet.node[1]};
}

}  // namespace

BoundarySplitter3d::BoundarySplitter3d(ConstrainedTetrahedralization& tetrahedralization,
                                       SurfaceSplitter& splitter)
    : t_(tetrahedralization), splitter_(splitter)
{
}

BoundarySplitter3d::Face BoundarySplitter3d::cornersOf(const SurfaceFacet& facet) const
{
    Face corners{vertexOf(facet.node[0]), vertexOf(facet.node[1]), vertexOf(facet.node[2])};
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Writes the split of the surface in vertices. The added facets must close what the removed ones leave open: their
/// perimeter is the boundary of the removed ones, but for the segment that gives way.
bool BoundarySplitter3d::prepare()
{
    faces_.clear();
    perimeter_.clear();
    boundary_.clear();
    edge_ = {};
    for (const FacetId facet : split_.removed) {
        const Face face = cornersOf(splitter_.mesh().facets[facet]);
        faces_.push_back(face);
        for (unsigned k = 0; k < 3; ++k) {
            const Edge side = ascending(face[k], face[(k + 1) % 3]);
            const auto twin = std::find(boundary_.begin(), boundary_.end(), side);
            if (twin == boundary_.end()) {
                boundary_.push_back(side);
            } else {
                boundary_.erase(twin);
            }
        }
    }
    if (split_.segment.isValid()) {
        const SurfaceSegment& segment = splitter_.mesh().segments[split_.segment];
        edge_ = {vertexOf(segment.node[0]), vertexOf(segment.node[1]), VertexId()};
        std::erase(boundary_, ascending(edge_[0], edge_[1]));
    }
    for (const SurfaceFacet& facet : split_.added) {
        const auto [a, b] = oldCorners(facet);
        perimeter_.push_back(ascending(vertexOf(a), vertexOf(b)));
    }
    std::sort(perimeter_.begin(), perimeter_.end());
    std::sort(boundary_.begin(), boundary_.end());
    if (perimeter_ == boundary_) return true;
    ++counts_.inconsistentSplits;
    return false;
}

const Cavity3d& BoundarySplitter3d::findCavity()
{
    const CavitySplit3d split{CavitySplit3d::Kind::Facets, edge_, faces_, perimeter_};
    return t_.delaunay->findCavity(t_.scale * split_.node.position, split);
}

SegmentId BoundarySplitter3d::encroachedSegment(const Cavity3d& cavity,
                                                const std::function<bool(SegmentId)>& mayEncroach) const
{
    const Triangulation3d& mesh = t_.mesh();
    SegmentId encroached;
    double deepest = 1.0;
    for (const TetId tet : cavity.tets) {
        if ((mesh.flags(tet) & tet_flag::kEdges) == 0 || mesh.region(tet) == kExteriorRegion) continue;
        for (int edge = 0; edge < 6; ++edge) {
            if (!mesh.isEdgeConstrained(tet, edge)) continue;
            const VertexId a = mesh.vertex(tet, kEdgeSlots[edge][0]);
            const VertexId b = mesh.vertex(tet, kEdgeSlots[edge][1]);
            const ProtectingBall ball = ProtectingBall::ofSegment(mesh.position(a), mesh.position(b));
            const double depth = ball.depthOf(cavity.point);
            if (!ball.contains(cavity.point) || depth >= deepest) continue;
            const SegmentId* segment = t_.segmentOf.find(unorderedPair(a, b));
            if (segment == nullptr || mayEncroach(*segment)) continue;
            deepest = depth;
            encroached = *segment;
        }
    }
    return encroached;
}

/// Whether a vertex was deleted, so that the cavity is to be looked for again.
bool BoundarySplitter3d::deleteVerticesIn(const Cavity3d& cavity, const ProtectingBall& ball)
{
    const Triangulation3d& mesh = t_.mesh();
    inBall_.clear();
    for (const CavityFace3d& face : cavity.faces) {
        for (const VertexId v : face.vertex) {
            if (isGhost(v) || mesh.classification(v).dimension != 3 || t_.nodeOf[v].isValid()) continue;
            if (ball.contains(mesh.position(v))) inBall_.push_back(v);
        }
    }
    std::sort(inBall_.begin(), inBall_.end());
    inBall_.erase(std::unique(inBall_.begin(), inBall_.end()), inBall_.end());
    bool isDeleted = false;
    for (const VertexId v : inBall_) {
        if (t_.delaunay->remove(v) != RemovalStatus::Removed) {
            ++counts_.keptVertices;
            continue;
        }
        ++counts_.deletedVertices;
        isDeleted = true;
        const auto filling = t_.delaunay->created();
        created_.insert(created_.end(), filling.begin(), filling.end());
    }
    return isDeleted;
}

/// Deletes what is in the ball and leaves the cavity that is to be committed.
bool BoundarySplitter3d::isCavityReady(const ProtectingBall& ball)
{
    constexpr int kMostRounds = 4;
    for (int round = 0; round < kMostRounds; ++round) {
        const Cavity3d& cavity = findCavity();
        if (cavity.status != CavityStatus::Ready) return false;
        if (deleteVerticesIn(cavity, ball)) continue;
        counts_.cutCavities += cavity.isCut ? 1 : 0;
        return true;
    }
    const Cavity3d& cavity = findCavity();
    counts_.cutCavities += cavity.isCut ? 1 : 0;
    return cavity.status == CavityStatus::Ready;
}

/// Makes the split that was evaluated, where a cavity takes it.
bool BoundarySplitter3d::commitIfReady(const ProtectingBall& ball, SurfaceSplitExtent extent,
                                       BoundarySplit3d& result)
{
    if (!isCavityReady(ball)) {
        ++counts_.blockedCavities;
        result.outcome = SplitOutcome3d::NotStarShaped;
        return false;
    }
    if (extent == SurfaceSplitExtent::Least) ++counts_.leastExtents;
    commit(result);
    return true;
}

void BoundarySplitter3d::commit(BoundarySplit3d& split)
{
    const EntityRef entity = split_.node.entity;
    VertexClass classification;
    classification.dimension = entity.dimension & 7u;
    classification.entity = entity.index & VertexClass::kNoEntity;
    const VertexId v = t_.delaunay->commit(classification).vertex;
    const auto star = t_.delaunay->created();
    created_.insert(created_.end(), star.begin(), star.end());
    made_ = splitter_.commit(split_);
    const SurfaceMesh& surface = splitter_.mesh();

    if (t_.nodeOf.size() <= v.value) t_.nodeOf.resize(v.value + 1u);
    if (t_.vertexOf.size() <= made_.node.value) t_.vertexOf.resize(made_.node.value + 1u);
    t_.nodeOf[v] = made_.node;
    t_.vertexOf[made_.node] = v;
    for (const Face& face : faces_) t_.facetOf.erase(face);
    for (const FacetId facet : made_.added)
        t_.facetOf.insertOrAssign(cornersOf(surface.facets[facet]), facet);
    split.surround.clear();
    for (const Edge& side : perimeter_) split.surround.insert(split.surround.end(), side.begin(), side.end());
    if (edge_[0].isValid()) {
        t_.segmentOf.erase(unorderedPair(edge_[0], edge_[1]));
        for (const SegmentId half : made_.halves) {
            const auto& ends = surface.segments[half].node;
            t_.segmentOf.insertOrAssign(unorderedPair(vertexOf(ends[0]), vertexOf(ends[1])), half);
        }
        split.surround.assign({edge_[0], edge_[1]});
    }
    std::sort(split.surround.begin(), split.surround.end());
    split.surround.erase(std::unique(split.surround.begin(), split.surround.end()), split.surround.end());
    split.vertex = v;
    split.outcome = SplitOutcome3d::Split;
}

BoundarySplit3d BoundarySplitter3d::splitFacet(FacetId facet,
                                               const std::function<bool(SegmentId)>& mayEncroach)
{
    created_.clear();
    BoundarySplit3d result;
    const Face corners = cornersOf(splitter_.mesh().facets[facet]);
    const std::optional<ProtectingBall> ball = ProtectingBall::ofFacet(
        t_.mesh().position(corners[0]), t_.mesh().position(corners[1]), t_.mesh().position(corners[2]));
    if (!ball) return result;
    for (const SurfaceSplitExtent extent : {SurfaceSplitExtent::Delaunay, SurfaceSplitExtent::Least}) {
        splitter_.evaluateFacet(facet, extent, split_);
        if (split_.status == SurfaceSplitStatus::Encroaches && !mayEncroach(split_.segment)) {
            result.outcome = SplitOutcome3d::EncroachesSegment;
            result.encroached = split_.segment;
            return result;
        }
        if (split_.status == SurfaceSplitStatus::TooSmall) result.outcome = SplitOutcome3d::TooSmall;
        if (split_.status != SurfaceSplitStatus::Ready || !prepare()) continue;
        const Cavity3d& cavity = findCavity();
        const SegmentId encroached = encroachedSegment(cavity, mayEncroach);
        if (encroached.isValid()) {
            result.outcome = SplitOutcome3d::EncroachesSegment;
            result.encroached = encroached;
            return result;
        }
        if (commitIfReady(*ball, extent, result)) return result;
    }
    return result;
}

BoundarySplit3d BoundarySplitter3d::splitSegment(SegmentId segment)
{
    created_.clear();
    BoundarySplit3d result;
    const auto& ends = splitter_.mesh().segments[segment].node;
    const ProtectingBall ball = ProtectingBall::ofSegment(t_.mesh().position(vertexOf(ends[0])),
                                                          t_.mesh().position(vertexOf(ends[1])));
    for (const SurfaceSplitExtent extent : {SurfaceSplitExtent::Delaunay, SurfaceSplitExtent::Least}) {
        splitter_.evaluateSegment(segment, extent, split_);
        if (split_.status == SurfaceSplitStatus::TooSmall) result.outcome = SplitOutcome3d::TooSmall;
        if (split_.status != SurfaceSplitStatus::Ready || !prepare()) continue;
        if (commitIfReady(ball, extent, result)) return result;
    }
    return result;
}

}  // namespace mesher
