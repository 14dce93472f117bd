#pragma once

#include "base/backlog_watch.h"
#include "base/bucket_queue.h"
#include "base/budget.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "surface_sampling/face_mesh.h"
#include "surface_sampling/face_replacement.h"
#include "surface_sampling/face_star.h"
#include "surface_sampling/facet_criteria.h"
#include "surface_sampling/facet_measures.h"
#include "surface_sampling/facet_split.h"
#include "surface_sampling/wall_rims.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace mesher {

/// What a face must know of the edges around it.
/// Threads   may be asked from several threads at once
class FaceBoundary
{
public:
    virtual ~FaceBoundary() = default;
    /// False for a segment that is as short as it may be.
    [[nodiscard]] virtual bool maySplit(SegmentId segment) const = 0;
    /// A segment that is split for nothing but its length or a node in its ball: it is next to the apex of an angle that no
    /// facet can be good in.
    [[nodiscard]] virtual bool isAtApex(SegmentId segment) const = 0;
    /// Two nodes on one shell around the apex of a small angle.
    [[nodiscard]] virtual bool spansSmallAngle(NodeId a, NodeId b) const = 0;
    [[nodiscard]] virtual BrepEdgeId edgeOf(SegmentId segment) const = 0;
    /// Of the segment that it is a piece of, as sizes and the shape of its edge have made it; 0 as long as that is not known.
    [[nodiscard]] virtual double wholeLengthOf(SegmentId segment) const = 0;
};

/// A flat facet between two edges of its face, on the rim of a wall or a strip.
struct RimPlace
{
    std::array<BrepEdgeId, 2> edge;
    double length = 0.0;   ///< of its side on the first edge
    double width = 0.0;    ///< from there to its corner on the second
    bool isStrip = false;  ///< of no wall that the rims know of
};

struct FaceRefinementOptions
{
    FacetCriteriaOptions criteria;
    FacetSplitOptions splits;
};

struct FaceRefinementCounts
{
    std::size_t sizeInsertions = 0;
    std::size_t qualityInsertions = 0;
    std::size_t boundaryInsertions = 0;  ///< vertices put on segments
    std::size_t removals = 0;            ///< free vertices that gave way to a segment's split
    std::size_t forcedStars = 0;         ///< vertices on segments beside which facets fold
    std::size_t lostSegments = 0;  ///< that had no side in the face; its mesh does not fit its edges then
    std::size_t deferred = 0;      ///< facets that waited for segments to be split
    std::size_t leftAtSmallAngles = 0;  ///< facets, see FacetLeft
    std::size_t leftForResolution = 0;  ///< facets
    std::size_t leftOnRims = 0;         ///< facets, see FaceRefiner::leaveFlatOn
    std::size_t leftOnStrips = 0;       ///< facets
    std::size_t releasedFans = 0;       ///< facets of fans around tips that had to be split
    FacetSplitCounts splits;

    FaceRefinementCounts& operator+=(const FaceRefinementCounts& other);
};

/// A split of a segment that all faces beside it follow.
struct SegmentVertex
{
    SegmentId segment;
    std::array<NodeId, 2> ends;  ///< of the segment, along its edge
    NodeId node;
    Vec3 position;
    std::array<SegmentId, 2> halves;
};

/// Refines the mesh of one face on the exact surface: the worst facet of those too large, then of those with too small an
/// angle, is removed by a vertex at the centre of its surface ball. Where that would be beyond a segment or encroach on one,
/// the segment is proposed for a split, which the owner of the edges makes in all faces at once.
/// Guarantees   the mesh stays a manifold with the same topology and segments; each vertex is an exact point of the surface;
///              with StopReason::Done and no proposals, each facet is as asked, or counted as left
/// Requires     a mesh that follows the surface (normals within 90 degrees)
/// Terminates   for angles up to 20.7 degrees, in practice 30; the floor and the budget end everything else
/// Cost         about constant per vertex
/// Reference    thesis §3.3.2.3; [chew1993] for the centres, [shewchuk2002] for the boundary, [miller2003] for small angles;
///              here the facets are kept by flips in the surface, not by a restricted Delaunay triangulation in space
class FaceRefiner
{
public:
    FaceRefiner(FaceMesh& mesh, const FaceGeometry& geometry, const FaceBoundary& boundary,
                const FaceRefinementOptions& options);

    /// Segments that are too long or encroached, as the mesh is: to be split before the inside is refined.
    void proposeSegments();
    /// What waited for proposals is looked at again, whatever became of these.
    void queueWaiting();
    /// Until nothing is left to do or all that is left waits for proposals.
    StopReason refine(Budget& budget);
    /// Facets that are queued.
    [[nodiscard]] std::size_t openCount() const { return sizeQueue_.size() + qualityQueue_.size(); }
    /// Ascending, each once.
    [[nodiscard]] std::vector<SegmentId> takeProposals();
    void insertOnSegment(const SegmentVertex& split);
    /// The star that such a vertex would have, in splitter().star(); free vertices stay. False if the face has no such side.
    [[nodiscard]] bool evaluateOnSegment(const SegmentVertex& split, StarExtent extent);
    /// Does a side of the face between these nodes end in a tip and on the ring around it?
    [[nodiscard]] bool isSpoke(const std::array<NodeId, 2>& ends) const;
    /// Has a facet split when refinement goes on, whatever its shape.
    void force(TriangleId t);
    void queueAll();
    /// Flat facets on the rims of walls are left as they are from now on, and do not split segments; `rims` must outlive it.
    void leaveFlatOn(const WallRims& rims) { rims_ = &rims; }
    /// Of a facet that is left so, or would be.
    [[nodiscard]] std::optional<RimPlace> rimPlaceOf(TriangleId t) const;
    /// Whether facets were left where none are to be left any more; these are to be looked at again then. Others of strips are marked as
    /// such.
    [[nodiscard]] bool hasFormerRim();
    /// Those that were given up, since what is around them has changed, among facets made locally Delaunay where coarse ones
    /// could not be. False if there are none that are new.
    bool queueGivenUp(RunContext& context);

    /// Whether the angle asked for was out of reach and the default was kept in its place.
    [[nodiscard]] double minAngle() const { return criteria_.minAngle(); }
    [[nodiscard]] bool hasGivenUpAngle() const { return hasGivenUpAngle_; }
    [[nodiscard]] FaceRefinementCounts counts() const;
    [[nodiscard]] FacetSplitter& splitter() { return splitter_; }
    [[nodiscard]] FaceMesh& mesh() { return mesh_; }
    /// Vertices that no other face knows.
    [[nodiscard]] std::size_t freeVertexCount() const { return mesh_.vertexCount() - boundVertices_; }
    /// To be told of a vertex for a node of the model's mesh that was not made here.
    void setVertexOf(NodeId node, VertexId v);

private:
    struct Waiting
    {
        TriangleId triangle;
        std::uint16_t generation = 0;
    };

    void queueTriangle(TriangleId t);
    void queueMade(const std::vector<TriangleId>& made);
    bool propose(SegmentId segment);
    void watchBacklog();
    void processTriangle(TriangleId t, FacetNeed need);
    [[nodiscard]] bool isAtSmallAngle(const FaceTriangle& record, const FacetShape& shape) const;
    void proposeAround(VertexId v);
    void proposeIfEncroached(EdgeLink side);
    void proposeIfNeeded(EdgeLink side);
    [[nodiscard]] bool isTooLong(EdgeLink side) const;
    bool leaveOnRim(TriangleId t);
    [[nodiscard]] std::optional<RimPlace> rimPlaceAt(EdgeLink side) const;
    [[nodiscard]] std::optional<RimPlace> placeBetween(EdgeLink side) const;
    [[nodiscard]] EdgeLink sideOf(const SegmentVertex& split) const;
    bool removeApex(EdgeLink side);
    void flipAround(VertexId v);
    [[nodiscard]] SurfaceFacts factsOnSide(EdgeLink side, const Vec3& position) const;
    void evaluateOnSide(EdgeLink side, const SegmentVertex& split, StarExtent extent);

    FaceMesh& mesh_;
    const FaceGeometry& geometry_;
    const FaceBoundary& boundary_;
    FacetCriteria criteria_;
    double floor_;
    FacetSplitter splitter_;
    FaceVertexRemoval removal_;
    BucketQueue<TriangleId> sizeQueue_;
    BucketQueue<TriangleId> qualityQueue_;
    std::vector<Waiting> waiting_;
    std::vector<SegmentId> proposals_;
    /// More than one where the face touches itself in the node.
    IndexedMap<NodeId, std::vector<VertexId>> verticesOf_;
    std::size_t boundVertices_ = 0;  ///< in `verticesOf_`
    FaceRefinementCounts counts_;
    BacklogWatch backlog_;
    bool hasGivenUpAngle_ = false;
    bool isWatched_;  ///< an angle above the default may be out of reach
    bool hasGivenUp_ = false;
    const WallRims* rims_ = nullptr;
    bool isTryingAgain_ = false;  ///< what was given up is tried by other means as well
};

}  // namespace mesher
