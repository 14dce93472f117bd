#include "delaunay/cavity3d.h"

#include "predicates/insphere.h"
#include "predicates/orient3d.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mesher {

namespace {

/// Tetrahedra that a cavity of replaced facets may grow by before it is given up.
constexpr std::size_t kMostGrowth = 16;

/// Conflicts that a cavity of replaced facets takes in at first. Of flat tetrahedra along a coarse or very thin surface thousands
/// are in conflict with one point, nearly all of which the repair would take out again, a few at a time. But where a coarse
/// facet sees a fine feature hundreds have to go at once, those around its edge for one: a cavity that so few do not make
/// star-shaped takes in more by the factor.
constexpr std::size_t kFirstConflicts = 128;
constexpr std::size_t kConflictGrowth = 16;

constexpr std::size_t kAllConflicts = std::numeric_limits<std::size_t>::max();

bool isSameFace(std::array<VertexId, 3> a, std::array<VertexId, 3> b)
{
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
}

bool isSameEdge(const std::array<VertexId, 2>& edge, VertexId a, VertexId b)
{
    return (edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a);
}

}  // namespace

// --- conflict search

inline bool CavityOperator3d::isInConflict(TetId tet, const Vec3& point, const StaticFilter3d& filter) const
{
    const TetRecord& record = mesh_.tetData()[tet.value];
    if (isGhost(record.vertex[3])) [[unlikely]]
        return isGhostInConflict(record, point, filter);
    return isInSphere(record, point, filter);
}

inline bool CavityOperator3d::isInSphere(const TetRecord& tet, const Vec3& point,
                                         const StaticFilter3d& filter) const
{
    const VertexRecord* vertices = mesh_.vertexData();
    return inspherePerturbed(filter, vertices[tet.vertex[0].value].position,
                             vertices[tet.vertex[1].value].position, vertices[tet.vertex[2].value].position,
                             vertices[tet.vertex[3].value].position, point) == Sign::Positive;
}

bool CavityOperator3d::isGhostInConflict(const TetRecord& ghost, const Vec3& point,
                                         const StaticFilter3d& filter) const
{
    const Sign side = orient3d(filter, mesh_.position(ghost.vertex[0]), mesh_.position(ghost.vertex[1]),
                               mesh_.position(ghost.vertex[2]), point);
    if (side != Sign::Zero) return side == Sign::Positive;
    // In the plane of the hull facet the circumcircle decides, which the sphere behind the facet cuts out of it.
    return isInSphere(mesh_.tet(ghost.neighbour[3].tet()), point, filter);
}

/// The search comes to the neighbours a few tetrahedra later: time enough to fetch them.
inline void CavityOperator3d::prefetchAround(TetId tet) const
{
    for (const TetFace neighbour : mesh_.tetData()[tet.value].neighbour) {
        __builtin_prefetch(mesh_.tetData() + neighbour.tet().value);
        __builtin_prefetch(mesh_.stateData() + neighbour.tet().value);
    }
}

bool CavityOperator3d::isSplitFace(const std::array<VertexId, 3>& face) const
{
    if (split_.kind == CavitySplit3d::Kind::Face) return isSameFace(face, split_.vertex);
    if (split_.kind == CavitySplit3d::Kind::Facets) {
        std::array<VertexId, 3> ascending = face;
        std::sort(ascending.begin(), ascending.end());
        return std::find(split_.faces.begin(), split_.faces.end(), ascending) != split_.faces.end();
    }
    const auto has = [&](VertexId v) { return std::find(face.begin(), face.end(), v) != face.end(); };
    return split_.kind == CavitySplit3d::Kind::Edge && has(split_.vertex[0]) && has(split_.vertex[1]);
}

/// Whether it is the edge that the point halves.
bool CavityOperator3d::isSplitEdge(VertexId a, VertexId b) const
{
    const bool hasEdge =
        split_.kind == CavitySplit3d::Kind::Edge || split_.kind == CavitySplit3d::Kind::Facets;
    return hasEdge && split_.vertex[0].isValid() && isSameEdge({split_.vertex[0], split_.vertex[1]}, a, b);
}

bool CavityOperator3d::isCrossingForbidden(TetFace face) const
{
    return mesh_.isFaceConstrained(face) && !isSplitFace(mesh_.faceVertices(face));
}

template <bool kConstrained>
void CavityOperator3d::collectConflicts(const Vec3& point, std::size_t most, const StaticFilter3d& filter)
{
    const TetRecord* const records = mesh_.tetData();
    TetState* const states = mesh_.stateData();
    std::vector<TetId>& tets = cavity_.tets;
    for (std::size_t next = 0; next < tets.size(); ++next) {
        const TetId inner = tets[next];
        const TetRecord record = records[inner.value];
        for (unsigned face = 0; face < 4; ++face) {
            const TetFace outer = record.neighbour[face];
            const TetId other = outer.tet();
            if constexpr (kConstrained) {
                if (isCrossingForbidden({inner, static_cast<int>(face)})) {
                    addFace(record, face, outer);
                    cavity_.constrainedFaces.push_back(outer);
                    continue;
                }
            }
            TetState& state = states[other.value];
            if ((state.flags & tet_flag::kInCavity) != 0) continue;
            const bool isInside = isInConflict(other, point, filter);
            // What of the hull is visible goes as a whole, or the hull would not stay convex.
            if (isInside && (tets.size() < most || mesh_.isGhostTet(other))) {
                state.flags |= tet_flag::kInCavity;
                tets.push_back(other);
                prefetchAround(other);
            } else {
                if constexpr (kConstrained) cavity_.isCut |= isInside;
                addFace(record, face, outer);
            }
        }
    }
    work_ += tets.size();
}

void CavityOperator3d::begin(const Vec3& point, std::span<const TetId> seeds, const CavitySplit3d& split)
{
    cavity_.status = CavityStatus::Ready;
    cavity_.point = point;
    cavity_.tets.assign(seeds.begin(), seeds.end());
    cavity_.faces.clear();
    cavity_.constraints.clear();
    cavity_.constrainedFaces.clear();
    cavity_.blocker = {};
    cavity_.repairs = 0;
    cavity_.isCut = false;
    blockingFace_ = TetFace();
    split_ = split;
    collectSplitPerimeter(seeds);
    for (const TetId seed : seeds) mark(seed);
}

void CavityOperator3d::repair(std::span<const TetId> seeds, const StaticFilter3d& filter)
{
    marked_ = cavity_.tets;
    while (cavity_.status == CavityStatus::Ready && repairOnce(seeds, filter)) refloodFromSeeds(seeds);
    unmarkAll();
}

void CavityOperator3d::unmarkAll()
{
    for (const TetId tet : marked_) unmark(tet);
}

const Cavity3d& CavityOperator3d::find(const Vec3& point, std::span<const TetId> seeds,
                                       const CavitySplit3d& split, const StaticFilter3d& filter)
{
    begin(point, seeds, split);
    collectConflicts<true>(point, kAllConflicts, filter);
    repair(seeds, filter);
    finish();
    return cavity_;
}

const Cavity3d& CavityOperator3d::findForFacets(const Vec3& point, const CavitySplit3d& split,
                                                const StaticFilter3d& filter)
{
    begin(point, {}, split);
    if (!seedFacets(filter)) {
        cavity_.status = CavityStatus::BlockedByConstraint;
        return cavity_;
    }
    const std::size_t most = grownSeeds_.size() + kMostGrowth;
    std::size_t mostConflicts = kFirstConflicts;
    for (;;) {
        begin(point, grownSeeds_, split);
        collectConflicts<true>(point, mostConflicts, filter);
        repair(grownSeeds_, filter);
        if (cavity_.status != CavityStatus::Ready && cavity_.isCut) {
            mostConflicts *= kConflictGrowth;
            continue;
        }
        // A tetrahedron at a replaced facet need not be in conflict with a point off the plane: the cavity grows where
        // such a one does not see the point.
        const TetId behind = tetBehindBlocker();
        if (!behind.isValid() || grownSeeds_.size() >= most) break;
        grownSeeds_.push_back(behind);
    }
    if (cavity_.status == CavityStatus::Ready && hasEnclosedVertex()) {
        cavity_.status = CavityStatus::NotStarShaped;
    }
    finish();
    return cavity_;
}

/// The tetrahedra that must go for the facets to go: those in front of them, both where the point is in the plane. A hull
/// facet goes only if the point lies beyond it. False if a facet is not there or cannot go.
bool CavityOperator3d::seedFacets(const StaticFilter3d& filter)
{
    grownSeeds_.clear();
    for (const auto& [a, b, c] : split_.faces) {
        const TetFace face = mesh_.findFace(a, b, c);
        if (!face.isValid() || !mesh_.isFaceConstrained(face)) return false;
        const auto [f0, f1, f2] = mesh_.faceVertices(face);
        const Sign side =
            orient3d(filter, mesh_.position(f0), mesh_.position(f1), mesh_.position(f2), cavity_.point);
        const TetId behind = mesh_.neighbour(face).tet();
        for (const TetId tet :
             {side != Sign::Negative ? face.tet() : TetId(), side != Sign::Positive ? behind : TetId()}) {
            if (!tet.isValid()) continue;
            if (mesh_.isGhostTet(tet) && !isInConflict(tet, cavity_.point, filter)) return false;
            if (std::find(grownSeeds_.begin(), grownSeeds_.end(), tet) == grownSeeds_.end()) {
                grownSeeds_.push_back(tet);
            }
        }
    }
    return !grownSeeds_.empty();
}

const Cavity3d& CavityOperator3d::findConflicts(const Vec3& point, TetId seed, std::size_t most,
                                                const StaticFilter3d& filter)
{
    begin(point, {&seed, 1}, {});
    collectConflicts<true>(point, most, filter);
    for (const TetId tet : cavity_.tets) unmark(tet);
    return cavity_;
}

const Cavity3d& CavityOperator3d::makeStarShaped(const StaticFilter3d& filter)
{
    const TetId seed = cavity_.tets.front();
    for (const TetId tet : cavity_.tets) mark(tet);
    repair({&seed, 1}, filter);
    finish();
    return cavity_;
}

/// The tetrahedron to grow by when facets of a curved surface are replaced.
TetId CavityOperator3d::tetBehindBlocker() const
{
    const bool mayGrow = cavity_.status == CavityStatus::NotStarShaped && blockingFace_.isValid() &&
                         !mesh_.isGhostTet(blockingFace_.tet());
    return mayGrow ? blockingFace_.tet() : TetId();
}

/// The constrained edge that the point halves may stay as an ordinary edge around the cavity.
void CavityOperator3d::releaseSplitEdge()
{
    const TetId at = mesh_.findEdge(split_.vertex[0], split_.vertex[1]);
    if (at.isValid()) mesh_.setEdgeConstrained(at, split_.vertex[0], split_.vertex[1], false);
}

/// Seeds that are not in conflict with the point can close around a vertex, which would be lost.
bool CavityOperator3d::hasEnclosedVertex()
{
    linker_.begin(mesh_.vertexLimit());
    for (const CavityFace3d& face : cavity_.faces) {
        for (const VertexId v : face.vertex) linker_.number(v);
    }
    const std::size_t onSurface = linker_.vertices().size();
    for (const TetId tet : cavity_.tets) {
        for (const VertexId v : mesh_.tet(tet).vertex) linker_.number(v);
    }
    return linker_.vertices().size() != onSurface;
}

void CavityOperator3d::finish()
{
    cavity_.constraints.clear();
    cavity_.constrainedFaces.clear();
    for (const CavityFace3d& face : cavity_.faces) {
        const TetFace inner = mesh_.neighbour(face.outer);
        CavityFaceConstraints3d carried;
        carried.region = mesh_.region(inner.tet());
        const bool hasEdges = (mesh_.flags(inner.tet()) & tet_flag::kEdges) != 0;
        for (unsigned k = 0; k < 3 && hasEdges; ++k) {
            const VertexId from = face.vertex[(k + 1) % 3];
            const VertexId to = face.vertex[(k + 2) % 3];
            const int edge = kEdgeOfSlots[mesh_.slotOf(inner.tet(), from)][mesh_.slotOf(inner.tet(), to)];
            if (mesh_.isEdgeConstrained(inner.tet(), edge) && !isSplitEdge(from, to)) {
                carried.edges = static_cast<std::uint8_t>(carried.edges | (1u << k));
            }
        }
        if (mesh_.isFaceConstrained(face.outer)) {
            carried.isReleased = !isCrossingForbidden(face.outer);
            if (carried.isReleased) {
                carried.region = mesh_.region(face.outer.tet());
            } else {
                cavity_.constrainedFaces.push_back(face.outer);
            }
        }
        cavity_.constraints.push_back(carried);
    }
}

/// What has to be left of the constraint to be split: all the tetrahedra at it are seeds.
void CavityOperator3d::collectSplitPerimeter(std::span<const TetId> seeds)
{
    splitPerimeter_.clear();
    splitsConstrainedEdge_ = false;
    if (split_.kind == CavitySplit3d::Kind::None) return;
    if (split_.kind == CavitySplit3d::Kind::Facets) {
        splitPerimeter_.assign(split_.perimeter.begin(), split_.perimeter.end());
        splitsConstrainedEdge_ = split_.vertex[0].isValid();
        return;
    }
    for (const TetId tet : seeds) {
        for (int i = 0; i < 4; ++i) {
            const auto corners = mesh_.faceVertices({tet, i});
            if (!mesh_.isFaceConstrained({tet, i}) || !isSplitFace(corners)) continue;
            for (unsigned k = 0; k < 3; ++k) {
                const VertexId a = corners[k];
                const VertexId b = corners[(k + 1) % 3];
                if (!isSplitEdge(a, b)) splitPerimeter_.push_back({a, b});
            }
        }
        if (split_.kind != CavitySplit3d::Kind::Edge) continue;
        const int a = mesh_.slotOf(tet, split_.vertex[0]);
        const int b = mesh_.slotOf(tet, split_.vertex[1]);
        splitsConstrainedEdge_ |= a >= 0 && b >= 0 && mesh_.isEdgeConstrained(tet, kEdgeOfSlots[a][b]);
    }
}

bool CavityOperator3d::isSplitPerimeter(VertexId a, VertexId b) const
{
    return std::any_of(splitPerimeter_.begin(), splitPerimeter_.end(),
                       [&](const auto& edge) { return isSameEdge(edge, a, b); });
}

// --- retriangulation

template <bool kConstrained>
TetId CavityOperator3d::retriangulate(VertexId vertex)
{
    const std::vector<CavityFace3d>& faces = cavity_.faces;
    std::vector<TetId>& slots = cavity_.tets;
    linker_.begin(mesh_.vertexLimit());
    localFaces_.resize(faces.size());
    if constexpr (kConstrained) created_.clear();
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (unsigned k = 0; k < 3; ++k) localFaces_[i].vertex[k] = linker_.number(faces[i].vertex[k]);
    }
    linker_.prepare();
    const std::size_t reused = std::min(slots.size(), faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const CavityFace3d& face = faces[i];
        const TetId tet = i < reused ? slots[i] : mesh_.allocateTet();
        if (i < reused) mesh_.renewTet(tet);
        TetRecord& record = mesh_.tetData()[tet.value];
        record.vertex = {vertex, face.vertex[0], face.vertex[1], face.vertex[2]};
        record.neighbour[0] = face.outer;
        mesh_.tetData()[face.outer.code >> 2].neighbour[face.outer.code & 3u] = TetFace(tet, 0);
        LocalFace& local = localFaces_[i];
        local.tet = tet;
        linker_.put(local.vertex[1], local.vertex[2], TetFace(tet, 1));
        linker_.put(local.vertex[2], local.vertex[0], TetFace(tet, 2));
        linker_.put(local.vertex[0], local.vertex[1], TetFace(tet, 3));
    }
    for (std::size_t i = reused; i < slots.size(); ++i) mesh_.freeTet(slots[i]);
    for (const LocalFace& local : localFaces_) {
        TetRecord& record = mesh_.tetData()[local.tet.value];
        record.neighbour[1] = linker_.get(local.vertex[2], local.vertex[1]);
        record.neighbour[2] = linker_.get(local.vertex[0], local.vertex[2]);
        record.neighbour[3] = linker_.get(local.vertex[1], local.vertex[0]);
    }
    if constexpr (kConstrained) carryConstraints(vertex);
    return localFaces_.front().tet;
}

void CavityOperator3d::carryConstraints(VertexId vertex)
{
    for (std::size_t i = 0; i < localFaces_.size(); ++i) {
        const TetId tet = localFaces_[i].tet;
        created_.push_back(tet);
        const CavityFaceConstraints3d& carried = cavity_.constraints[i];
        std::uint16_t& flags = mesh_.state(tet).flags;
        const TetFace outer = cavity_.faces[i].outer;
        if (carried.isReleased) {
            std::uint16_t& outerFlags = mesh_.state(outer.tet()).flags;
            outerFlags = static_cast<std::uint16_t>(outerFlags & ~tet_flag::face(outer.face()));
        } else if (mesh_.isFaceConstrained(outer)) {
            flags |= tet_flag::face(0);
        }
        for (int k = 0; k < 3; ++k) {
            if ((carried.edges >> k & 1) == 0) continue;
            flags |= tet_flag::edge(kEdgeOfSlots[(k + 1) % 3 + 1][(k + 2) % 3 + 1]);
        }
        mesh_.setRegion(tet, carried.region);
        for (const VertexId v : cavity_.faces[i].vertex) {
            if (!isGhost(v)) mesh_.setIncidentTet(v, tet);
        }
    }
    mesh_.setIncidentTet(vertex, localFaces_.front().tet);
    if (split_.kind != CavitySplit3d::Kind::None) constrainSplitParts();
}

void CavityOperator3d::constrainSplitParts()
{
    for (const LocalFace& local : localFaces_) {
        std::uint16_t& flags = mesh_.state(local.tet).flags;
        for (int k = 0; k < 3; ++k) {
            const VertexId a = mesh_.vertex(local.tet, (k + 1) % 3 + 1);
            const VertexId b = mesh_.vertex(local.tet, (k + 2) % 3 + 1);
            if (isSplitPerimeter(a, b)) flags |= tet_flag::face(k + 1);
            const VertexId end = mesh_.vertex(local.tet, k + 1);
            const bool isHalf =
                splitsConstrainedEdge_ && (end == split_.vertex[0] || end == split_.vertex[1]);
            if (isHalf) flags |= tet_flag::edge(kEdgeOfSlots[0][k + 1]);
        }
    }
}

TetId CavityOperator3d::commit(VertexId vertex)
{
    MESHER_PRECONDITION(cavity_.status == CavityStatus::Ready);
    if (split_.kind == CavitySplit3d::Kind::Facets && split_.vertex[0].isValid()) releaseSplitEdge();
    return retriangulate<true>(vertex);
}

TetId CavityOperator3d::insertUnconstrained(VertexId vertex, TetId seed, const StaticFilter3d& filter)
{
    cavity_.tets.clear();
    cavity_.faces.clear();
    cavity_.tets.push_back(seed);
    mark(seed);
    collectConflicts<false>(mesh_.position(vertex), kAllConflicts, filter);
    return retriangulate<false>(vertex);
}

std::size_t CavityOperator3d::bytes() const
{
    return cavity_.tets.capacity() * sizeof(TetId) + cavity_.faces.capacity() * sizeof(CavityFace3d) +
           cavity_.constraints.capacity() * sizeof(CavityFaceConstraints3d) +
           cavity_.constrainedFaces.capacity() * sizeof(TetFace) +
           localFaces_.capacity() * sizeof(LocalFace) + linker_.bytes();
}

}  // namespace mesher
