#pragma once

#include "delaunay/edge_linker.h"
#include "delaunay/triangulation3d.h"
#include "predicates/static_filter.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// A face of the surface of a cavity.
struct CavityFace3d
{
    /// The face seen from the tetrahedron outside.
    TetFace outer;
    /// Its vertices, such that the new tetrahedron (point, vertex[0], vertex[1], vertex[2]) is positively oriented;
    /// the ghost, if any, is last.
    std::array<VertexId, 3> vertex;
};

/// What a cavity face hands on to the tetrahedron that is built on it.
struct CavityFaceConstraints3d
{
    /// Bit k: the edge opposite vertex[k] is constrained.
    std::uint8_t edges = 0;
    /// A facet that gives way, with the point in front of it: an ordinary face from now on.
    bool isReleased = false;
    RegionId region;
};

enum class CavityStatus : std::uint8_t
{
    Ready,
    /// The point does not see a face of every tetrahedron that has it: constraints or inverted neighbours are in the way.
    NotStarShaped,
    /// A constrained face or edge has the point or would be deleted, and no smaller cavity saves it.
    BlockedByConstraint
};

/// A region of tetrahedra that an insertion would replace by the star of the new point.
struct Cavity3d
{
    CavityStatus status = CavityStatus::Ready;
    Vec3 point;
    std::vector<TetId> tets;
    std::vector<CavityFace3d> faces;
    /// Beside `faces`, entry by entry.
    std::vector<CavityFaceConstraints3d> constraints;
    /// The constrained faces on its surface, seen from outside: the candidates for encroachment.
    std::vector<TetFace> constrainedFaces;
    /// The constraint in the way of a blocked cavity: its two or three vertices, the third invalid for an edge.
    std::array<VertexId, 3> blocker;
    /// Tetrahedra that were taken out again to make it star-shaped (thesis §4.7.2).
    std::uint32_t repairs = 0;
    /// The search has met the most tetrahedra it was to collect: others are in conflict as well.
    bool isCut = false;
};

/// The constraint that an insertion is allowed to cut: because the point lies on it, or because facets of a curved surface
/// give way to the star of a point that is off their planes.
struct CavitySplit3d
{
    enum class Kind : std::uint8_t
    {
        None,
        Face,
        Edge,
        Facets
    };

    Kind kind = Kind::None;
    /// The ends of the edge, or the corners of the face. Of facets: the ends of the constrained edge that the point halves,
    /// else invalid.
    std::array<VertexId, 3> vertex;
    /// Of facets: the constrained faces to be replaced, each with ascending corners.
    std::span<const std::array<VertexId, 3>> faces = {};
    /// Of facets: the edges that make the new constrained faces with the point; each vertex of `faces` is at one of them.
    std::span<const std::array<VertexId, 2>> perimeter = {};
};

/// Bowyer–Watson insertion in two phases: `find` evaluates and changes nothing, `commit` cannot fail.
///
/// Guarantees   a committed cavity was star-shaped around its point, and every constrained face and edge that the split
///              did not name is still there; the tetrahedra around stay linked (checkTopology)
/// Requires     `seeds` have the point in their closure (a ghost one: the point lies outside of its hull facet), or are
///              in conflict with it. The triangulation is (constrained) Delaunay, else the result is only star-shaped
/// Cost         proportional to the cavity; no allocation once the scratch arrays have grown
/// Reference    [bowyer1981] [watson1981] [gosselin] §1.2.2, §4.7.2
class CavityOperator3d
{
public:
    explicit CavityOperator3d(Triangulation3d& triangulation) : mesh_(triangulation) {}

    /// The tetrahedra in conflict with the point that can be reached from the seeds without crossing a constrained
    /// face, made star-shaped. The returned cavity is valid until the next call.
    const Cavity3d& find(const Vec3& point, std::span<const TetId> seeds, const CavitySplit3d& split,
                         const StaticFilter3d& filter);

    /// The cavity of a point that replaces facets. A facet stays as an ordinary face where the tetrahedron behind it, seen
    /// from the point, is not in conflict. Where very many are, those next to the facets make the cavity if they can,
    /// and the new tetrahedra need flips to be Delaunay.
    const Cavity3d& findForFacets(const Vec3& point, const CavitySplit3d& split,
                                  const StaticFilter3d& filter);

    /// The first half of `find` without a split: the tetrahedra in conflict and `constrainedFaces`, not yet star-shaped.
    /// Who wants the point must ask `makeStarShaped` with nothing changed in between. With more conflicts than `most` only
    /// the nearest to the seed are there (`isCut`).
    const Cavity3d& findConflicts(const Vec3& point, TetId seed, std::size_t most,
                                  const StaticFilter3d& filter);
    const Cavity3d& makeStarShaped(const StaticFilter3d& filter);

    /// Replaces the cavity found last, whose status must be Ready, by the star of `vertex`, whose position is the
    /// cavity's point. Returns a tetrahedron of the star.
    TetId commit(VertexId vertex);

    /// find and commit in one for a Delaunay triangulation without any constraint, as fast as can be: incidentTet of the
    /// vertices and `cavity()` are not kept up.
    TetId insertUnconstrained(VertexId vertex, TetId seed, const StaticFilter3d& filter);

    [[nodiscard]] const Cavity3d& cavity() const { return cavity_; }
    /// Tetrahedra that the searches and repairs of all cavities have looked at: what they cost, whatever the machine.
    [[nodiscard]] std::uint64_t work() const { return work_; }
    /// The star that the last commit made.
    [[nodiscard]] std::span<const TetId> created() const { return created_; }
    /// The neighbours of the vertex of the last commit, the ghost included.
    [[nodiscard]] std::span<const VertexId> neighbours() const { return linker_.vertices(); }
    [[nodiscard]] std::size_t bytes() const;

private:
    struct LocalFace
    {
        std::array<std::uint32_t, 3> vertex;
        TetId tet;
    };

    template <bool kConstrained>
    void collectConflicts(const Vec3& point, std::size_t most, const StaticFilter3d& filter);
    bool isInConflict(TetId tet, const Vec3& point, const StaticFilter3d& filter) const;
    bool isInSphere(const TetRecord& tet, const Vec3& point, const StaticFilter3d& filter) const;
    bool isGhostInConflict(const TetRecord& ghost, const Vec3& point, const StaticFilter3d& filter) const;
    void prefetchAround(TetId tet) const;
    bool isCrossingForbidden(TetFace face) const;
    bool isSplitFace(const std::array<VertexId, 3>& face) const;
    bool isSplitEdge(VertexId a, VertexId b) const;
    bool isSplitPerimeter(VertexId a, VertexId b) const;
    void collectSplitPerimeter(std::span<const TetId> seeds);
    void addFace(const TetRecord& inner, unsigned face, TetFace outer);
    void begin(const Vec3& point, std::span<const TetId> seeds, const CavitySplit3d& split);
    void repair(std::span<const TetId> seeds, const StaticFilter3d& filter);
    void unmarkAll();
    bool seedFacets(const StaticFilter3d& filter);
    TetId tetBehindBlocker() const;
    bool hasEnclosedVertex();
    void releaseSplitEdge();

    void refloodFromSeeds(std::span<const TetId> seeds);
    bool repairOnce(std::span<const TetId> seeds, const StaticFilter3d& filter);
    bool takeOut(TetId tet, std::span<const TetId> seeds, CavityStatus reason);
    bool repairVisibility(std::span<const TetId> seeds, const StaticFilter3d& filter);
    bool repairEnclosedFaces(std::span<const TetId> seeds, const StaticFilter3d& filter);
    bool repairEnclosedEdges(std::span<const TetId> seeds, const StaticFilter3d& filter);
    TetId tetBehindEdge(TetId tet, int edge, const StaticFilter3d& filter) const;
    bool isEdgeEnclosed(TetId tet, int edge) const;
    void finish();

    template <bool kConstrained>
    TetId retriangulate(VertexId vertex);
    void carryConstraints(VertexId vertex);
    void constrainSplitParts();

    [[nodiscard]] bool isMarked(TetId tet) const { return (mesh_.flags(tet) & tet_flag::kInCavity) != 0; }
    void mark(TetId tet) { mesh_.state(tet).flags |= tet_flag::kInCavity; }
    void unmark(TetId tet)
    {
        mesh_.state(tet).flags = static_cast<std::uint16_t>(mesh_.state(tet).flags & ~tet_flag::kInCavity);
    }

    Triangulation3d& mesh_;
    Cavity3d cavity_;
    CavitySplit3d split_;
    std::vector<TetId> marked_;
    std::vector<TetId> grownSeeds_;
    std::vector<TetId> created_;
    /// The face in the way, seen from outside; invalid if it is an edge.
    TetFace blockingFace_;
    std::vector<TetId> previous_;
    std::vector<LocalFace> localFaces_;
    EdgeLinker<TetFace> linker_;
    /// Perimeter edges of the split facets: with the new point they make the constrained faces that replace them.
    std::vector<std::array<VertexId, 2>> splitPerimeter_;
    bool splitsConstrainedEdge_ = false;
    std::uint64_t work_ = 0;
};

/// Orders the vertices of a face that its tetrahedron sees on its positive side for a new tetrahedron that has the new
/// point in front: reversed, and turned until the ghost is last.
inline std::array<VertexId, 3> facingPoint(VertexId f0, VertexId f1, VertexId f2)
{
    if (isGhost(f0)) return {f2, f1, f0};
    if (isGhost(f1)) return {f0, f2, f1};
    return {f1, f0, f2};
}

inline void CavityOperator3d::addFace(const TetRecord& inner, unsigned face, TetFace outer)
{
    const int* slots = kFaceSlots[face];
    cavity_.faces.push_back({outer, facingPoint(inner.vertex[static_cast<unsigned>(slots[0])],
                                                inner.vertex[static_cast<unsigned>(slots[1])],
                                                inner.vertex[static_cast<unsigned>(slots[2])])});
}

}  // namespace mesher
