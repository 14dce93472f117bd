#include "refinement/insert_circumcentre.h"

#include "predicates/insphere.h"

#include <algorithm>
#include <cmath>

namespace mesher {

Vec3 onGrid(const Vec3& p)
{
    constexpr double kSmallestCoordinate = 0x1p-147;
    const auto rounded = [](double x) { return std::abs(x) < kSmallestCoordinate ? 0.0 : x; };
    return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

/// The circumcentre of the tetrahedron; where that is lost in rounding, of its largest face, which is in conflict too.
Attempt CircumcentreInsertion::attempt(TetId tet)
{
    inTheWay_ = {};
    const std::optional<Vec3> centre = state_.criteria.circumcentre(tet);
    const Attempt first = centre ? attemptAt(tet, onGrid(*centre)) : Attempt::Impossible;
    if (first != Attempt::Impossible || badTets_.isSinkPhase()) return first;
    // Flat ones on a ring have no circumcentre to speak of.
    if (const auto fan = state_.fans.withRingThrough(state_.mesh.tet(tet).vertex)) {
        if (insertCentreOf(*fan, tet) == Attempt::Inserted) return Attempt::Inserted;
    }
    if (!state_.criteria.isNearlyFlat(tet)) return centre ? insertShortOf(tet, *centre) : first;
    const std::optional<Vec3> ofFace = state_.criteria.centreOfLargestFace(tet);
    if (!ofFace) return Attempt::Impossible;
    ++state_.counts.flatTets;
    return attemptAt(tet, onGrid(*ofFace));
}

/// Beside a fan as well, unlike the other insertions: what is left there is bad already.
Attempt CircumcentreInsertion::attemptNearer(TetId tet)
{
    const std::optional<Vec3> centre = state_.criteria.circumcentre(tet);
    if (!centre) return Attempt::Impossible;
    Vec3 centroid;
    for (const VertexId v : state_.mesh.tet(tet).vertex) centroid = centroid + 0.25 * state_.mesh.position(v);
    for (const double share : {0.8, 0.6, 0.4, 0.2}) {
        const Vec3 point = onGrid(centroid + share * (*centre - centroid));
        if (!isFinite(point) || !hasRoomAtCorners(tet, point)) continue;
        const Encroached3d encroached = findInTheWay(*state_.t.delaunay, tet, point);
        if (encroached.segment[0].isValid() || encroached.facet.isValid()) continue;
        const RegionId region = state_.mesh.region(tet);
        const Cavity3d& cavity = state_.t.delaunay->makeStarShaped();
        if (cavity.status != CavityStatus::Ready || !hasRoom(cavity, tet)) continue;
        ++state_.counts.shortInsertions;
        insert(region, cavity.repairs > 0);
        return Attempt::Inserted;
    }
    return Attempt::Impossible;
}

Attempt CircumcentreInsertion::attemptAt(TetId tet, const Vec3& point)
{
    Delaunay3d& delaunay = *state_.t.delaunay;
    const Encroached3d encroached = findInTheWay(delaunay, tet, point);
    if (encroached.segment[0].isValid() || encroached.facet.isValid()) return reject(tet, encroached);
    const RegionId region = state_.mesh.region(tet);
    const Cavity3d& cavity = delaunay.makeStarShaped();
    if (cavity.status != CavityStatus::Ready) {
        ++state_.counts.abortedInsertions;
        return Attempt::Impossible;
    }
    if (const auto fan = fanCrowdedBy(cavity)) return insertCentreOf(*fan, tet);
    insert(region, cavity.repairs > 0);
    return Attempt::Inserted;
}

/// Where the boundary cannot be split: the circumcentre all the same, or a vertex halfway to the facet before it, if
/// that leaves room around it.
Attempt CircumcentreInsertion::insertShortOf(TetId tet, const Vec3& centre)
{
    // Vertices in the middle of a flat wall, or at a narrow face, would only be followed by more.
    if (state_.walls.wallBeside(tet) != nullptr || state_.strips.faceBeside(tet)) return Attempt::Impossible;
    const TetFace blocking = firstConstraintTowards(state_.mesh, tet, centre, state_.t.delaunay->filter());
    Vec3 point = centre;
    if (blocking.isValid()) {
        Vec3 start;
        for (const VertexId v : state_.mesh.tet(tet).vertex) start = start + 0.25 * state_.mesh.position(v);
        point = start + 0.5 * crossingOf(blocking, start, centre) * (centre - start);
    }
    if (!isFinite(point)) return Attempt::Impossible;
    // Its own corners are on the surface of every cavity.
    if (!hasRoomAtCorners(tet, onGrid(point))) return Attempt::Impossible;
    const RegionId region = state_.mesh.region(tet);
    if (state_.t.delaunay->findConflicts(onGrid(point), tet, kOrdinaryConflicts).isCut)
        return Attempt::Impossible;
    const Cavity3d& cavity = state_.t.delaunay->makeStarShaped();
    if (cavity.status != CavityStatus::Ready || !hasRoom(cavity, tet) || makesFlatter(cavity, tet))
        return Attempt::Impossible;
    if (const auto fan = fanCrowdedBy(cavity)) return insertCentreOf(*fan, tet);
    ++state_.counts.shortInsertions;
    insert(region, cavity.repairs > 0);
    return Attempt::Inserted;
}

/// Whether the star of a point that is no circumcentre would have flatter tetrahedra than the one that it is for. Such a point can lie
/// next to any face of its cavity, and the flat ones there would be followed by flatter ones without an end.
bool CircumcentreInsertion::makesFlatter(const Cavity3d& cavity, TetId tet) const
{
    constexpr double kFlat = 0.02;  // about a degree
    const auto at = [&](VertexId v) { return state_.mesh.position(v); };
    const auto flatness = [](const TetCorners& corners) {
        return score(TetMeasure::MinimumDihedralSine, corners);
    };
    const auto& v = state_.mesh.tet(tet).vertex;
    const double bound = std::min(kFlat, flatness({at(v[0]), at(v[1]), at(v[2]), at(v[3])}));
    return std::any_of(cavity.faces.begin(), cavity.faces.end(), [&](const CavityFace3d& face) {
        const auto& [a, b, c] = face.vertex;
        return !isGhost(c) && flatness({cavity.point, at(a), at(b), at(c)}) < bound;
    });
}

/// Where the line from `start` (0) to `end` (1) meets the plane of a face.
double CircumcentreInsertion::crossingOf(TetFace face, const Vec3& start, const Vec3& end) const
{
    const auto [a, b, c] = state_.mesh.faceVertices(face);
    const Vec3& origin = state_.mesh.position(a);
    const Vec3 normal = cross(state_.mesh.position(b) - origin, state_.mesh.position(c) - origin);
    return dot(origin - start, normal) / dot(end - start, normal);
}

/// The part of the length scale that an insertion short of the circumcentre has to keep away.
double CircumcentreInsertion::roomOf(TetId tet) const
{
    constexpr double kLeastShare = 0.4;
    double room = 0.0;
    for (const VertexId v : state_.mesh.tet(tet).vertex) room += 0.25 * kLeastShare * state_.scale.guard(v);
    return room;
}

bool CircumcentreInsertion::hasRoomAtCorners(TetId tet, const Vec3& point) const
{
    const double room = roomOf(tet);
    const auto& corners = state_.mesh.tet(tet).vertex;
    return std::all_of(corners.begin(), corners.end(),
                       [&](VertexId v) { return length(state_.mesh.position(v) - point) >= room; });
}

std::optional<std::uint32_t> CircumcentreInsertion::fanCrowdedBy(const Cavity3d& cavity) const
{
    if (!state_.fans.hasAny()) return {};
    for (const CavityFace3d& face : cavity.faces) {
        if (const auto fan = state_.fans.crowdedBy(cavity.point, face.vertex)) return fan;
    }
    return {};
}

/// In the place of the circumcentre, which lies beside it.
Attempt CircumcentreInsertion::insertCentreOf(std::uint32_t fan, TetId tet)
{
    const std::optional<Vec3> centre = state_.fans.freeCentre(fan);
    if (!centre) return Attempt::Impossible;
    const auto& v = state_.mesh.tet(tet).vertex;
    const Vec3 point = onGrid(*centre);
    const bool isInConflict =
        insphere(state_.t.delaunay->filter(), state_.mesh.position(v[0]), state_.mesh.position(v[1]),
                 state_.mesh.position(v[2]), state_.mesh.position(v[3]), point) == Sign::Positive;
    if (!isInConflict) return Attempt::Impossible;
    const RegionId region = state_.mesh.region(tet);
    if (state_.t.delaunay->findConflicts(point, tet, kOrdinaryConflicts).isCut) return Attempt::Impossible;
    const Cavity3d& cavity = state_.t.delaunay->makeStarShaped();
    if (cavity.status != CavityStatus::Ready) return Attempt::Impossible;
    insert(region, cavity.repairs > 0);
    state_.fans.take(fan);
    return Attempt::Inserted;
}

/// Whether all of the cavity's surface that counts keeps that away.
bool CircumcentreInsertion::hasRoom(const Cavity3d& cavity, TetId tet) const
{
    const Triangulation3d& mesh = state_.mesh;
    const double room = roomOf(tet);
    for (const CavityFace3d& face : cavity.faces) {
        for (const VertexId v : face.vertex) {
            if (length(mesh.position(v) - cavity.point) < room) return false;
        }
    }
    return std::all_of(cavity.constrainedFaces.begin(), cavity.constrainedFaces.end(), [&](TetFace outer) {
        const auto [a, b, c] = mesh.faceVertices(mesh.neighbour(outer));
        const Vec3& origin = mesh.position(a);
        const Vec3 normal = cross(mesh.position(b) - origin, mesh.position(c) - origin);
        return dot(cavity.point - origin, normal) >= 0.5 * room * length(normal);
    });
}

void CircumcentreInsertion::insert(RegionId region, bool isRepaired)
{
    ConstrainedTetrahedralization& t = state_.t;
    VertexClass classification;
    classification.entity = (region.value - 1) & VertexClass::kNoEntity;
    const VertexId v = t.delaunay->commit(classification).vertex;
    if (t.nodeOf.size() <= v.value) t.nodeOf.resize(v.value + v.value / 4u + 16u);
    t.nodeOf[v] = NodeId();
    const bool isLow = state_.scale.assign(v, t.delaunay->neighboursOfCommitted());
    state_.walls.assign(v, t.delaunay->neighboursOfCommitted(), region);
    for (const TetId created : t.delaunay->created()) badTets_.push(created);
    if (isRepaired) {
        for (const TetId flipped : state_.flipAround(t.delaunay->created())) {
            if (state_.isMeshed(flipped)) badTets_.push(flipped);
        }
    }
    if (isLow) badTets_.gradeAround(v);
}

Attempt CircumcentreInsertion::reject(TetId tet, const Encroached3d& encroached)
{
    if (badTets_.isSinkPhase()) return Attempt::Impossible;
    ++state_.counts.rejectedCentres;
    if (encroached.facet.isValid()) {
        const FacetId* facet = state_.facetAt(encroached.facet);
        if (facet != nullptr) inTheWay_ = state_.entityOf(*facet);
    }
    if (encroached.segment[0].isValid() && !wouldShrink(tet, encroached.segment)) {
        const SegmentId* segment = state_.segmentAt(encroached.segment[0], encroached.segment[1]);
        if (segment != nullptr) inTheWay_ = state_.entityOf(*segment);
        if (segment != nullptr && boundary_.pushSegment(*segment)) return Attempt::Rejected;
    }
    const bool mayPush =
        encroached.facet.isValid() && !wouldShrink(tet, state_.mesh.faceVertices(encroached.facet));
    if (mayPush && boundary_.pushFacetAt(encroached.facet)) return Attempt::Rejected;
    return Attempt::Impossible;
}

/// Beside a small angle of the input a bad tetrahedron must not make edges shorter than its own, or they would get
/// shorter and shorter.
bool CircumcentreInsertion::wouldShrink(TetId tet, std::span<const VertexId> entity)
{
    if (!state_.guard.hasAny() || state_.judge(tet).need != TetNeed::Quality) return false;
    const double angle = state_.smallAngleBeside(entity);
    if (angle >= (isInsisting_ ? kLeastInsisted : SmallAngleGuard::kSmallDihedral)) return false;
    double longest = 0.0;
    for (std::size_t i = 0; i < entity.size(); ++i) {
        const Vec3 side =
            state_.mesh.position(entity[(i + 1) % entity.size()]) - state_.mesh.position(entity[i]);
        longest = std::max(longest, squaredLength(side));
    }
    if (0.25 * longest >= shortestSquaredEdge(tet)) return false;
    ++state_.counts.guardedSplits;
    return true;
}

double CircumcentreInsertion::shortestSquaredEdge(TetId tet) const
{
    const auto& v = state_.mesh.tet(tet).vertex;
    double shortest = squaredLength(state_.mesh.position(v[1]) - state_.mesh.position(v[0]));
    for (const auto& [from, to] : kEdgeSlots) {
        const Vec3 edge = state_.mesh.position(v[static_cast<unsigned>(to)]) -
                          state_.mesh.position(v[static_cast<unsigned>(from)]);
        shortest = std::min(shortest, squaredLength(edge));
    }
    return shortest;
}

}  // namespace mesher
