#include "delaunay/delaunay3d.h"

#include "delaunay/spatial_order.h"
#include "delaunay/vertex_removal3d.h"
#include "predicates/coordinate_range.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"

#include <algorithm>
#include <string>
#include <utility>

namespace mesher {

namespace {

bool areCollinear(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == Sign::Zero &&
           orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == Sign::Zero &&
           orient2d({a.x, a.z}, {b.x, b.z}, {c.x, c.z}) == Sign::Zero;
}

/// -0 and 0 are one place; only one of them may reach the hash of a mesh.
Vec3 withoutNegativeZero(const Vec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

}  // namespace

Delaunay3d::Delaunay3d(std::uint64_t seed) : cavities_(mesh_), random_(seed) {}

Delaunay3d::~Delaunay3d() = default;

void Delaunay3d::expectPointsIn(const Box3& box)
{
    if (box.isEmpty() || (filterBox_.contains(box.low) && filterBox_.contains(box.high))) return;
    filterBox_.include(box.low);
    filterBox_.include(box.high);
    filter_ = StaticFilter3d::forBox(filterBox_);
}

Result<void> checkPoint3d(const Vec3& point, std::string_view name)
{
    if (!isFinite(point)) {
        return Error{ErrorCode::NonFinitePoint,
                     "a coordinate is not a finite number",
                     std::string(name),
                     {},
                     "repair the input"};
    }
    if (!isInExactRange(point)) {
        return Error{ErrorCode::OutOfRange, "a coordinate is too large or too small for exact arithmetic",
                     std::string(name), point, "scale the points with PowerOfTwoScaling"};
    }
    return {};
}

// --- below dimension 3

bool Delaunay3d::raisesDimension(const Vec3& point) const
{
    switch (dimension_) {
        case -1:
        case 0: return true;
        case 1: return !areCollinear(mesh_.position(basis_[0]), mesh_.position(basis_[1]), point);
        default:
            return orient3d(mesh_.position(basis_[0]), mesh_.position(basis_[1]), mesh_.position(basis_[2]),
                            point) != Sign::Zero;
    }
}

VertexId Delaunay3d::insertPending(const Vec3& point, VertexClass classification)
{
    const auto found = pending_.find(point);
    if (found != pending_.end()) return found->second;
    const VertexId vertex = mesh_.addVertex(point, classification);
    pending_.emplace(point, vertex);
    if (!raisesDimension(point)) return vertex;
    basis_.push_back(vertex);
    if (++dimension_ == 3) leavePendingState();
    return vertex;
}

void Delaunay3d::makeFirstTet()
{
    std::array<VertexId, 4> corner{basis_[0], basis_[1], basis_[2], basis_[3]};
    if (orient3d(mesh_.position(corner[0]), mesh_.position(corner[1]), mesh_.position(corner[2]),
                 mesh_.position(corner[3])) == Sign::Negative) {
        std::swap(corner[2], corner[3]);
    }
    const TetId inner = mesh_.allocateTet();
    mesh_.tet(inner).vertex = corner;
    std::array<TetId, 4> ghost;
    for (int i = 0; i < 4; ++i) {
        const auto [f0, f1, f2] = mesh_.faceVertices({inner, i});
        const TetId tet = mesh_.allocateTet();
        ghost[static_cast<unsigned>(i)] = tet;
        mesh_.tet(tet).vertex = {f1, f0, f2, kGhostVertex};
        mesh_.link({inner, i}, {tet, 3});
    }
    for (unsigned i = 0; i < 4; ++i) {
        for (unsigned j = i + 1; j < 4; ++j) {
            mesh_.link({ghost[i], mesh_.slotOf(ghost[i], corner[j])},
                       {ghost[j], mesh_.slotOf(ghost[j], corner[i])});
        }
    }
    for (const VertexId v : corner) mesh_.setIncidentTet(v, inner);
    recent_ = inner;
}

void Delaunay3d::leavePendingState()
{
    makeFirstTet();
    std::vector<VertexId> waiting;
    std::vector<Vec3> places;
    for (const auto& [place, vertex] : pending_) {
        if (std::find(basis_.begin(), basis_.end(), vertex) != basis_.end()) continue;
        waiting.push_back(vertex);
        places.push_back(place);
    }
    pending_.clear();
    basis_.clear();
    for (const std::uint32_t index : brioOrder(std::span<const Vec3>(places), random_())) {
        recent_ = placeVertex(waiting[index]);
    }
    mesh_.rebuildIncidentTets();
}

void Delaunay3d::enterPendingState()
{
    for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
        if (mesh_.isAlive(TetId(i))) mesh_.freeTet(TetId(i));
    }
    recent_ = TetId();
    dimension_ = -1;
    for (std::uint32_t i = 0; i < mesh_.vertexLimit(); ++i) {
        const VertexId vertex(i);
        if (!mesh_.isVertexAlive(vertex)) continue;
        mesh_.setIncidentTet(vertex, TetId());
        const Vec3 place = mesh_.position(vertex);
        pending_.emplace(place, vertex);
        if (!raisesDimension(place)) continue;
        basis_.push_back(vertex);
        ++dimension_;
    }
    MESHER_INVARIANT(dimension_ < 3);
}

void Delaunay3d::removePending(VertexId vertex)
{
    pending_.erase(mesh_.position(vertex));
    mesh_.removeVertex(vertex);
    if (std::find(basis_.begin(), basis_.end(), vertex) == basis_.end()) return;
    basis_.clear();
    dimension_ = -1;
    for (const auto& [place, other] : pending_) {
        if (!raisesDimension(place)) continue;
        basis_.push_back(other);
        ++dimension_;
    }
}

// --- insertion

/// Flips are made by others, so the tetrahedron of the last insertion may be gone.
TetId Delaunay3d::startOfWalk(TetId hint) const
{
    const auto isUsable = [&](TetId t) {
        return t.isValid() && t.value < mesh_.tetLimit() && mesh_.isAlive(t);
    };
    if (isUsable(hint)) return hint;
    if (isUsable(recent_)) return recent_;
    TetId first(0u);
    while (!mesh_.isAlive(first)) ++first.value;
    return first;
}

bool Delaunay3d::isOnConstraint(const Location3d& location) const
{
    if (location.kind == Location3d::Kind::Face)
        return mesh_.isFaceConstrained({location.tet, location.index});
    if (location.kind != Location3d::Kind::Edge) return false;
    if (mesh_.isEdgeConstrained(location.tet, location.index)) return true;
    const VertexId a = mesh_.vertex(location.tet, kEdgeSlots[location.index][0]);
    const VertexId b = mesh_.vertex(location.tet, kEdgeSlots[location.index][1]);
    std::vector<TetId> ring;
    mesh_.collectEdgeRing(location.tet, a, b, ring);
    return std::any_of(ring.begin(), ring.end(), [&](TetId tet) {
        for (int face = 0; face < 4; ++face) {
            const VertexId opposite = mesh_.vertex(tet, face);
            if (opposite != a && opposite != b && mesh_.isFaceConstrained({tet, face})) return true;
        }
        return false;
    });
}

TetId Delaunay3d::placeVertex(VertexId vertex)
{
    const TetId found = walk3d(mesh_, mesh_.position(vertex), startOfWalk(recent_), filter_, random_);
    return cavities_.insertUnconstrained(vertex, found, filter_);
}

VertexId Delaunay3d::insertTrusted(const Vec3& point, VertexClass classification)
{
    if (dimension_ < 3) return insertPending(point, classification);
    const TetId found = walk3d(mesh_, point, startOfWalk(recent_), filter_, random_);
    if (!mesh_.isGhostTet(found)) {
        for (const VertexId v : mesh_.tet(found).vertex) {
            if (mesh_.position(v) == point) return v;
        }
    }
    const VertexId vertex = mesh_.addVertex(point, classification);
    recent_ = cavities_.insertUnconstrained(vertex, found, filter_);
    return vertex;
}

Result<Insertion3d> Delaunay3d::insert(Vec3 point, TetId hint, ConstraintPolicy policy)
{
    const Result<void> valid = checkPoint3d(point, "point");
    if (!valid) return valid.error();
    point = withoutNegativeZero(point);
    expectPointsIn({point, point});
    if (dimension_ < 3) {
        const std::uint32_t before = mesh_.vertexCount();
        const VertexId vertex = insertPending(point, {});
        const bool isNew = mesh_.vertexCount() > before;
        const TetId tet = dimension_ == 3 ? mesh_.incidentTet(vertex) : TetId();
        return Insertion3d{isNew ? InsertionStatus::Inserted : InsertionStatus::Duplicate, vertex, tet, {}};
    }
    const TetId found = walk3d(mesh_, point, startOfWalk(hint), filter_, random_);
    const Location3d location = classifyLocation3d(mesh_, point, found, filter_);
    if (location.kind == Location3d::Kind::Vertex) {
        recent_ = location.tet;
        return Insertion3d{InsertionStatus::Duplicate, mesh_.vertex(location.tet, location.index),
                           location.tet, location};
    }
    if (policy == ConstraintPolicy::Refuse && isOnConstraint(location)) {
        return Insertion3d{InsertionStatus::OnConstraint, {}, {}, location};
    }
    findCavity(point, location, policy);
    Insertion3d outcome = commit();
    outcome.location = location;
    return outcome;
}

Result<Location3d> Delaunay3d::locate(Vec3 point, TetId hint)
{
    const Result<void> valid = checkPoint3d(point, "point");
    if (!valid) return valid.error();
    if (dimension_ < 3) {
        return Error{ErrorCode::DegenerateInput,
                     "the points do not span space",
                     {},
                     point,
                     "insert four points that are not coplanar first"};
    }
    expectPointsIn({point, point});
    return classifyLocation3d(mesh_, point, walk3d(mesh_, point, startOfWalk(hint), filter_, random_),
                              filter_);
}

const Cavity3d& Delaunay3d::findCavity(Vec3 point, const Location3d& location, ConstraintPolicy policy)
{
    MESHER_PRECONDITION(location.kind != Location3d::Kind::Vertex);
    point = withoutNegativeZero(point);
    expectPointsIn({point, point});
    CavitySplit3d split;
    seeds_.assign(1, location.tet);
    if (location.kind == Location3d::Kind::Face) {
        const TetFace face(location.tet, location.index);
        if (!mesh_.isFaceConstrained(face)) {
            seeds_.push_back(mesh_.neighbour(face).tet());
        } else if (policy == ConstraintPolicy::Split) {
            seeds_.push_back(mesh_.neighbour(face).tet());
            split = {CavitySplit3d::Kind::Face, mesh_.faceVertices(face)};
        }
    }
    if (location.kind == Location3d::Kind::Edge) {
        const VertexId a = mesh_.vertex(location.tet, kEdgeSlots[location.index][0]);
        const VertexId b = mesh_.vertex(location.tet, kEdgeSlots[location.index][1]);
        mesh_.collectEdgeRing(location.tet, a, b, seeds_);
        if (policy == ConstraintPolicy::Split) split = {CavitySplit3d::Kind::Edge, {a, b, VertexId()}};
    }
    return cavities_.find(point, seeds_, split, filter_);
}

const Cavity3d& Delaunay3d::findCavity(Vec3 point, const CavitySplit3d& split)
{
    point = withoutNegativeZero(point);
    expectPointsIn({point, point});
    return cavities_.findForFacets(point, split, filter_);
}

const Cavity3d& Delaunay3d::findConflicts(Vec3 point, TetId seed, std::size_t most)
{
    point = withoutNegativeZero(point);
    expectPointsIn({point, point});
    return cavities_.findConflicts(point, seed, most, filter_);
}

std::span<const TetId> Delaunay3d::created() const
{
    return isRemovalLast_ ? removal_->created() : cavities_.created();
}

Insertion3d Delaunay3d::commit(VertexClass classification)
{
    const Cavity3d& cavity = cavities_.cavity();
    counters_.cavityRepairs += cavity.repairs;
    if (cavity.status != CavityStatus::Ready) {
        ++counters_.blockedInsertions;
        const bool isBlocked = cavity.status == CavityStatus::BlockedByConstraint;
        return {isBlocked ? InsertionStatus::Blocked : InsertionStatus::NotStarShaped, {}, {}, {}};
    }
    const VertexId vertex = mesh_.addVertex(cavity.point, classification);
    recent_ = cavities_.commit(vertex);
    isRemovalLast_ = false;
    return {InsertionStatus::Inserted, vertex, recent_, {}};
}

// --- removal and storage

RemovalStatus Delaunay3d::remove(VertexId vertex)
{
    MESHER_PRECONDITION(mesh_.isVertexAlive(vertex));
    if (dimension_ < 3) {
        removePending(vertex);
        return RemovalStatus::Removed;
    }
    if (!removal_) removal_ = std::make_unique<VertexRemoval3d>(mesh_);
    switch (removal_->find(vertex)) {
        case VertexHole3d::OnConstraint: return RemovalStatus::OnConstraint;
        case VertexHole3d::Untriangulable: ++counters_.blockedRemovals; return RemovalStatus::Blocked;
        case VertexHole3d::WholeSpace:
            mesh_.removeVertex(vertex);
            enterPendingState();
            return RemovalStatus::Removed;
        case VertexHole3d::Ready: break;
    }
    recent_ = removal_->commit();
    isRemovalLast_ = true;
    return RemovalStatus::Removed;
}

void Delaunay3d::clear()
{
    mesh_.clear();
    filterBox_ = Box3{};
    filter_ = StaticFilter3d{};
    dimension_ = -1;
    recent_ = TetId();
    counters_ = {};
    pending_.clear();
    basis_.clear();
}

Renumbering3d Delaunay3d::compact()
{
    Renumbering3d map = mesh_.compact();
    if (recent_.isValid()) recent_ = map.tet[recent_];
    for (auto& [place, vertex] : pending_) vertex = map.vertex[vertex];
    for (VertexId& vertex : basis_) vertex = map.vertex[vertex];
    return map;
}

std::size_t Delaunay3d::bytes() const
{
    return mesh_.bytes() + cavities_.bytes() + seeds_.capacity() * sizeof(TetId);
}

}  // namespace mesher
