#include "delaunay/delaunay2d.h"

#include "delaunay/flips2d.h"
#include "delaunay/spatial_order.h"
#include "predicates/coordinate_range.h"
#include "predicates/orient2d.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace mesher {
namespace {

/// Points inserted between two looks at the cancellation.
constexpr std::size_t kChunk = 256;

/// Adding zero makes the two zeros one.
Vec2 withoutNegativeZeros(Vec2 p) { return {p.x + 0.0, p.y + 0.0}; }

Error faultOf(Vec2 point, std::string name)
{
    Error error;
    error.entity = std::move(name);
    if (isFinite(point)) {
        error.code = ErrorCode::OutOfRange;
        error.message = "a coordinate is outside of the range in which predicates are exact";
        error.point = Vec3{point.x, point.y, 0.0};
        error.remedy = "scale the model by a power of two";
    } else {
        error.code = ErrorCode::NonFinitePoint;
        error.message = "a coordinate is infinite or not a number";
        error.remedy = "repair or leave out the point";
    }
    return error;
}

Error tooManyVertices()
{
    Error error;
    error.code = ErrorCode::OutOfRange;
    error.message = "more vertices than can be numbered";
    error.remedy = "split the point set";
    return error;
}

}  // namespace

int Delaunay2d::dimension() const
{
    if (mesh_.triangleCount() != 0) return 2;
    return mesh_.vertexCount() < 2 ? static_cast<int>(mesh_.vertexCount()) - 1 : 1;
}

Result<BulkInsertion2d> Delaunay2d::insertPoints(std::span<const Vec2> points, RunContext* context)
{
    if (points.size() > Triangulation2d::kMaxVertices - mesh_.vertexSlots()) return tooManyVertices();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isInExactRange(points[i])) return faultOf(points[i], "point " + std::to_string(i));
    }
    for (const Vec2& p : points) box_.include(p);
    filter_ = StaticFilter2d::forBox(box_);
    mesh_.reserve(mesh_.vertexCount() + points.size());

    BulkInsertion2d result;
    result.vertices.resize(points.size());
    const std::vector<std::uint32_t> order = brioOrder(points, seed_);
    for (std::size_t begin = 0; begin < order.size(); begin += kChunk) {
        if (context != nullptr && !context->mayGoOn()) {
            result.stopReason = StopReason::Cancelled;
            break;
        }
        insertChunk(points, std::span(order).subspan(begin, std::min(kChunk, order.size() - begin)), result);
    }
    return result;
}

void Delaunay2d::insertChunk(std::span<const Vec2> points, std::span<const std::uint32_t> order,
                             BulkInsertion2d& result)
{
    // Gathered at once the scattered reads overlap; one by one each would wait for the memory.
    std::array<Vec2, kChunk> gathered;
    for (std::size_t i = 0; i < order.size(); ++i) gathered[i] = withoutNegativeZeros(points[order[i]]);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Insertion2d insertion = insertChecked(gathered[i], lastTriangle_, StarCheck::Trust);
        result.vertices[order[i]] = insertion.vertex;
        if (insertion.outcome == InsertOutcome::Duplicate) ++result.duplicates;
    }
}

Result<Insertion2d> Delaunay2d::insert(Vec2 point, TriangleId hint)
{
    if (!isInExactRange(point)) return faultOf(point, "point");
    if (mesh_.vertexCount() >= Triangulation2d::kMaxVertices) return tooManyVertices();
    includeInBox(point);
    return insertChecked(withoutNegativeZeros(point), startFor(hint), StarCheck::Repair);
}

Location2d Delaunay2d::locate(Vec2 point, TriangleId hint) const
{
    MESHER_PRECONDITION(isInExactRange(point));
    if (mesh_.triangleCount() == 0) return {};
    return mesher::locate(mesh_, filterFor(point), point, startFor(hint));
}

void Delaunay2d::findCavity(Vec2 point, const Location2d& location, Cavity2d& cavity, StarCheck check) const
{
    mesher::findCavity(mesh_, filterFor(point), withoutNegativeZeros(point), location, check, cavity);
    cavity.revision = revision_;
}

VertexId Delaunay2d::commit(const Cavity2d& cavity)
{
    MESHER_PRECONDITION(cavity.revision == revision_);
    ++revision_;
    includeInBox(cavity.point);
    counters_.starRepairs += cavity.repairs;
    ++counters_.insertions;
    const VertexId vertex = mesh_.addVertex(cavity.point);
    lastTriangle_ = commitCavity(mesh_, cavity, vertex);
    recordInsert(vertex, cavity.point);
    return vertex;
}

RemovalOutcome Delaunay2d::remove(VertexId vertex, RemovalPolicy policy)
{
    MESHER_PRECONDITION(mesh_.isAlive(vertex));
    const bool joinsChains = policy == RemovalPolicy::StraightChainsToo;
    record(joinsChains ? ReplayKind::RemoveFromChain : ReplayKind::Remove, vertex);
    if (mesh_.triangleCount() == 0) {
        lineVertices_.erase(mesh_.position(vertex));
        mesh_.removeVertex(vertex);
        ++counters_.removals;
        return RemovalOutcome::Removed;
    }
    ChainEnds chain;
    if (hasConstrainedEdge(vertex)) {
        if (joinsChains) chain = straightChainThrough(vertex);
        if (!chain.from.isValid()) return RemovalOutcome::KeptConstrained;
    }
    if (isLastOffLine(mesh_, filter_, vertex, removalWorkspace_)) {
        for (const auto& corner : removalWorkspace_.ring) {
            if (mesh_.isConstrained(corner.outer)) return RemovalOutcome::KeptLastTriangles;
        }
        lowerDimension(vertex);
    } else {
        counters_.flips +=
            removeVertex(mesh_, filter_, vertex, chain.from.isValid() ? &chain : nullptr, removalWorkspace_);
        const VertexId neighbour = removalWorkspace_.ring.front().vertex;
        lastTriangle_ = mesh_.triangleAt(neighbour);
    }
    ++counters_.removals;
    ++revision_;
    return RemovalOutcome::Removed;
}

Result<SegmentRecovery2d> Delaunay2d::recoverSegment(VertexId a, VertexId b)
{
    Error error;
    if (a == b || !mesh_.isAlive(a) || !mesh_.isAlive(b)) {
        error.code = ErrorCode::InvalidArgument;
        error.message = "a segment needs two different vertices of the triangulation";
    } else if (mesh_.triangleCount() == 0) {
        error.code = ErrorCode::DegenerateInput;
        error.message = "all vertices lie on one line, so there are no edges to constrain";
        error.remedy = "insert a point off the line first";
    } else {
        ++revision_;
        record(ReplayKind::Constrain, a, b);
        auto result = mesher::recoverSegment(mesh_, filter_, a, b, segmentWorkspace_);
        if (!result) return result;
        ++counters_.segments;
        counters_.flips += result->recoveryFlips + result->delaunayFlips;
        return result;
    }
    error.entity = "segment " + std::to_string(a.value) + "-" + std::to_string(b.value);
    return error;
}

void Delaunay2d::constrainEdge(EdgeLink edge)
{
    MESHER_PRECONDITION(mesh_.edgeFrom(edge) != kGhostVertex && mesh_.edgeTo(edge) != kGhostVertex);
    record(ReplayKind::Constrain, mesh_.edgeFrom(edge), mesh_.edgeTo(edge));
    mesh_.setConstrained(edge, true);
    ++revision_;
}

void Delaunay2d::unconstrainEdge(EdgeLink edge)
{
    record(ReplayKind::Unconstrain, mesh_.edgeFrom(edge), mesh_.edgeTo(edge));
    mesh_.setConstrained(edge, false);
    suspects_.assign(1, edge);
    counters_.flips += restoreDelaunay(mesh_, filter_, suspects_);
    ++revision_;
}

Triangulation2d::Renumbering Delaunay2d::compact()
{
    auto map = mesh_.compact();
    if (lastTriangle_.isValid()) lastTriangle_ = map.triangles[lastTriangle_];
    for (auto& [point, vertex] : lineVertices_) vertex = map.vertices[vertex];
    ++revision_;
    return map;
}

Insertion2d Delaunay2d::insertChecked(Vec2 point, TriangleId hint, StarCheck check)
{
    if (mesh_.triangleCount() == 0) return insertOnLine(point);
    const Location2d location = mesher::locate(mesh_, filter_, point, hint);
    if (location.kind == Location2d::Kind::OnVertex) {
        ++counters_.duplicates;
        return {mesh_.triangle(location.triangle()).v[location.index()], InsertOutcome::Duplicate};
    }
    const bool splits = location.kind == Location2d::Kind::OnEdge && mesh_.isConstrained(location.edge);
    mesher::findCavity(mesh_, filter_, point, location, check, cavity_);
    const VertexId vertex = mesh_.addVertex(point);
    lastTriangle_ = commitCavity(mesh_, cavity_, vertex);
    counters_.starRepairs += cavity_.repairs;
    ++counters_.insertions;
    ++revision_;
    recordInsert(vertex, point);
    return {vertex, splits ? InsertOutcome::SplitConstraint : InsertOutcome::Inserted};
}

Insertion2d Delaunay2d::insertOnLine(Vec2 point)
{
    const auto found = lineVertices_.find(point);
    if (found != lineVertices_.end()) {
        ++counters_.duplicates;
        return {found->second, InsertOutcome::Duplicate};
    }
    const VertexId vertex = mesh_.addVertex(point);
    ++counters_.insertions;
    ++revision_;
    recordInsert(vertex, point);
    const bool isOnLine =
        lineVertices_.size() < 2 ||
        orient2d(lineVertices_.begin()->first, lineVertices_.rbegin()->first, point) == Sign::Zero;
    if (isOnLine) {
        lineVertices_.emplace(point, vertex);
    } else {
        raiseDimension(vertex);
    }
    return {vertex, InsertOutcome::Inserted};
}

/// The vertices on the line and one off it: a fan of triangles, made from one end of the line to the other.
void Delaunay2d::raiseDimension(VertexId apex)
{
    auto next = lineVertices_.begin();
    const VertexId first = (next++)->second;
    const VertexId second = (next++)->second;
    const bool turnsLeft =
        orient2d(mesh_.position(first), mesh_.position(second), mesh_.position(apex)) == Sign::Positive;
    makeFirstTriangle(turnsLeft ? first : second, turnsLeft ? second : first, apex);
    for (; next != lineVertices_.end(); ++next) connect(next->second, lastTriangle_);
    lineVertices_.clear();
}

void Delaunay2d::makeFirstTriangle(VertexId a, VertexId b, VertexId c)
{
    const TriangleId t = mesh_.allocateTriangle();
    const TriangleId ghosts[3] = {mesh_.allocateTriangle(), mesh_.allocateTriangle(),
                                  mesh_.allocateTriangle()};
    const VertexId corners[3] = {a, b, c};
    for (unsigned i = 0; i < 3; ++i) {
        mesh_.triangle(t).v[i] = corners[i];
        mesh_.setTriangleAt(corners[i], t);
        Triangle2d& ghost = mesh_.triangle(ghosts[i]);
        ghost.v[0] = corners[previousCorner(i)];
        ghost.v[1] = corners[nextCorner(i)];
        ghost.v[2] = kGhostVertex;
        mesh_.link(EdgeLink(t, i), EdgeLink(ghosts[i], 2));
        mesh_.link(EdgeLink(ghosts[i], 0), EdgeLink(ghosts[previousCorner(i)], 1));
    }
    lastTriangle_ = t;
}

void Delaunay2d::lowerDimension(VertexId vertex)
{
    lineVertices_.clear();
    for (const auto& corner : removalWorkspace_.ring) {
        if (corner.vertex != kGhostVertex)
            lineVertices_.emplace(mesh_.position(corner.vertex), corner.vertex);
    }
    mesh_.freeAllTriangles();
    mesh_.removeVertex(vertex);
    lastTriangle_ = TriangleId();
}

void Delaunay2d::connect(VertexId vertex, TriangleId hint)
{
    const Vec2 point = mesh_.position(vertex);
    const Location2d location = mesher::locate(mesh_, filter_, point, hint);
    mesher::findCavity(mesh_, filter_, point, location, StarCheck::Repair, cavity_);
    lastTriangle_ = commitCavity(mesh_, cavity_, vertex);
    counters_.starRepairs += cavity_.repairs;
}

void Delaunay2d::includeInBox(Vec2 point)
{
    if (box_.contains(point)) return;
    box_.include(point);
    filter_ = StaticFilter2d::forBox(box_);
}

StaticFilter2d Delaunay2d::filterFor(Vec2 point) const
{
    // The filter's bounds hold inside the box only; one that decides nothing holds everywhere.
    return box_.contains(point) ? filter_ : StaticFilter2d{};
}

bool Delaunay2d::hasConstrainedEdge(VertexId vertex) const
{
    bool found = false;
    mesh_.forEachTriangleAround(vertex, [&](EdgeLink opposite) {
        found = mesh_.triangle(opposite.triangle()).isConstrained(nextCorner(opposite.edge()));
        return !found;
    });
    return found;
}

ChainEnds Delaunay2d::straightChainThrough(VertexId vertex) const
{
    VertexId ends[2];
    unsigned count = 0;
    mesh_.forEachTriangleAround(vertex, [&](EdgeLink opposite) {
        // The edge that runs from the vertex to the end of the opposite edge.
        if (!mesh_.triangle(opposite.triangle()).isConstrained(nextCorner(opposite.edge()))) return true;
        if (count < 2) ends[count] = mesh_.edgeTo(opposite);
        ++count;
        return true;
    });
    if (count != 2) return {};
    const Vec2 from = mesh_.position(ends[0]);
    const Vec2 to = mesh_.position(ends[1]);
    if (orient2d(filter_, from, mesh_.position(vertex), to) != Sign::Zero) return {};
    return {ends[0], ends[1]};
}

}  // namespace mesher
