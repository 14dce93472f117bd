#pragma once

#include "base/box.h"
#include "base/result.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "delaunay/cavity2d.h"
#include "delaunay/locate2d.h"
#include "delaunay/replay_log.h"
#include "delaunay/segment_recovery2d.h"
#include "delaunay/triangulation2d.h"
#include "delaunay/vertex_removal2d.h"
#include "predicates/static_filter.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace mesher {

enum class InsertOutcome
{
    Inserted,
    SplitConstraint,  ///< inserted on a constrained edge, whose halves are constrained
    Duplicate         ///< nothing was inserted: there is a vertex at this point
};

struct Insertion2d
{
    VertexId vertex;  ///< the new vertex, or the one that was there
    InsertOutcome outcome = InsertOutcome::Inserted;
};

struct BulkInsertion2d
{
    /// By input index; equal points share a vertex. Invalid for points that were not reached before a cancellation.
    std::vector<VertexId> vertices;
    std::size_t duplicates = 0;
    StopReason stopReason = StopReason::Done;
};

enum class RemovalPolicy
{
    FreeVertices,      ///< only vertices without a constrained edge
    StraightChainsToo  ///< also those in the middle of two collinear constrained edges, which become one
};

enum class RemovalOutcome
{
    Removed,
    KeptConstrained,  ///< constrained edges meet in the vertex: nothing was changed
    KeptLastTriangles  ///< without the vertex all triangles and with them constrained edges would go: not changed
};

/// What has been done so far; for reports and for ceilings in tests.
struct Delaunay2dCounters
{
    std::size_t insertions = 0;
    std::size_t duplicates = 0;
    std::size_t removals = 0;
    std::size_t segments = 0;
    std::size_t flips = 0;
    std::size_t starRepairs = 0;
};

/// The constrained Delaunay triangulation of a set of points and segments of the plane, kept through every change.
/// Guarantees   exact: whatever the points, all triangles are positively oriented and every unconstrained edge is
///              locally Delaunay. Cocircular points are decided by a symbolic perturbation, so the triangulation is a
///              function of the points' coordinates and the constrained edges alone (delaunay_check2d.h, mesh_hash2d.h)
/// Requires     points in the exact range of the predicates (coordinate_range.h); others are refused with an Error
/// Degenerate   fewer than three vertices, or all of them on one line: they are kept without triangles until a point
///              off the line arrives
/// Cost         insertion in bulk O(n log n) with a small constant; one by one O(1) from a near hint. Nothing is
///              allocated per operation once the scratch has grown
/// Units        model units; -0.0 becomes 0.0
/// Reference    [bowyer1981] [watson1981] for insertion, [chew1989] for the constrained triangulation, [amenta2003] for
///              the order; thesis section 1.2
class Delaunay2d
{
public:
    /// `seed` of the insertion order in bulk; the triangulation does not depend on it, the numbering does.
    explicit Delaunay2d(std::uint64_t seed = 1) : seed_(seed) {}

    [[nodiscard]] const Triangulation2d& mesh() const { return mesh_; }
    [[nodiscard]] const Delaunay2dCounters& counters() const { return counters_; }
    /// -1 without a vertex, 0 with one, 1 with all vertices on a line, else 2.
    [[nodiscard]] int dimension() const;

    /// Inserts many points at once, in an order of its own; vertices are numbered in that order, which keeps what is
    /// near in the plane near in memory. A bad point is an Error, and then none is inserted.
    [[nodiscard]] Result<BulkInsertion2d> insertPoints(std::span<const Vec2> points,
                                                       RunContext* context = nullptr);
    /// Inserts one point; `hint` is a triangle that may be near it, a dead or invalid one is ignored.
    [[nodiscard]] Result<Insertion2d> insert(Vec2 point, TriangleId hint = {});

    /// Where the point lies. Requires a point in the exact range.
    [[nodiscard]] Location2d locate(Vec2 point, TriangleId hint = {}) const;

    /// A filter for predicates on the vertices and the point.
    [[nodiscard]] StaticFilter2d filterFor(Vec2 point) const;

    /// What inserting the point would do; `location` is that of `locate` and neither on a vertex nor NoTriangles.
    void findCavity(Vec2 point, const Location2d& location, Cavity2d& cavity,
                    StarCheck check = StarCheck::Repair) const;
    /// Does it. Requires that nothing was changed since `findCavity`. To abandon a cavity just drop it.
    VertexId commit(const Cavity2d& cavity);

    /// Removes an alive vertex.
    RemovalOutcome remove(VertexId vertex, RemovalPolicy policy = RemovalPolicy::FreeVertices);

    /// Makes the segment a chain of constrained edges (segment_recovery2d.h); with an Error nothing is changed.
    [[nodiscard]] Result<SegmentRecovery2d> recoverSegment(VertexId a, VertexId b);
    /// The vertices on the segment that was recovered last, both ends included.
    [[nodiscard]] const std::vector<VertexId>& lastSegment() const { return segmentWorkspace_.vertices; }
    void constrainEdge(EdgeLink edge);
    /// Gives an edge free, and restores the Delaunay property around it.
    void unconstrainEdge(EdgeLink edge);

    /// Properties that do not take part in the triangulation.
    void setRegion(TriangleId triangle, RegionId region) { mesh_.setRegion(triangle, region); }
    void setLengthScale(VertexId vertex, double scale) { mesh_.setLengthScale(vertex, scale); }
    void setOrigin(VertexId vertex, VertexOrigin origin, std::uint32_t entity)
    {
        mesh_.setOrigin(vertex, origin, entity);
    }

    /// Writes down every change from now on, vertices labelled by their ids; null to stop. The log must outlive this
    /// object or the next call.
    void recordTo(ReplayLog* log) { log_ = log; }

    void reserve(std::size_t vertexCount) { mesh_.reserve(vertexCount); }
    Triangulation2d::Renumbering compact();

private:
    struct LexicographicOrder
    {
        bool operator()(Vec2 a, Vec2 b) const { return isLexicographicallyLess(a, b); }
    };

    void recordInsert(VertexId vertex, Vec2 point)
    {
        if (log_ != nullptr) log_->add(ReplayOperation::insert(vertex.value, point));
    }
    void record(ReplayKind kind, VertexId vertex)
    {
        if (log_ != nullptr) log_->add(ReplayOperation::on(kind, {vertex.value}));
    }
    void record(ReplayKind kind, VertexId a, VertexId b)
    {
        if (log_ != nullptr) log_->add(ReplayOperation::on(kind, {a.value, b.value}));
    }
    void insertChunk(std::span<const Vec2> points, std::span<const std::uint32_t> order,
                     BulkInsertion2d& result);
    Insertion2d insertChecked(Vec2 point, TriangleId hint, StarCheck check);
    Insertion2d insertOnLine(Vec2 point);
    void raiseDimension(VertexId apex);
    void makeFirstTriangle(VertexId a, VertexId b, VertexId c);
    void lowerDimension(VertexId vertex);
    void connect(VertexId vertex, TriangleId hint);
    void includeInBox(Vec2 point);
    [[nodiscard]] TriangleId startFor(TriangleId hint) const
    {
        return mesh_.isAlive(hint) ? hint : lastTriangle_;
    }
    /// The ends of a straight constrained chain through the vertex; invalid ids if there is none.
    [[nodiscard]] ChainEnds straightChainThrough(VertexId vertex) const;
    [[nodiscard]] bool hasConstrainedEdge(VertexId vertex) const;

    std::uint64_t seed_;
    Triangulation2d mesh_;
    TriangleId lastTriangle_;
    /// All vertices as long as they lie on one line; empty once there are triangles.
    std::map<Vec2, VertexId, LexicographicOrder> lineVertices_;
    Box2 box_;
    StaticFilter2d filter_;
    Delaunay2dCounters counters_;
    /// Counts changes, so that a stale cavity is told.
    std::uint64_t revision_ = 0;
    ReplayLog* log_ = nullptr;

    Cavity2d cavity_;
    SegmentWorkspace2d segmentWorkspace_;
    RemovalWorkspace2d removalWorkspace_;
    std::vector<EdgeLink> suspects_;
};

}  // namespace mesher
