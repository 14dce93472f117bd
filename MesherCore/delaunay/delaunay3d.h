#pragma once

#include "base/box.h"
#include "base/random.h"
#include "base/result.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "delaunay/cavity3d.h"
#include "delaunay/locate3d.h"
#include "delaunay/triangulation3d.h"
#include "predicates/static_filter.h"

#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace mesher {

/// Whether bulk insertion adds scaffold points (scaffold.h) to a surface-like point set.
enum class ScaffoldPolicy : std::uint8_t
{
    None,
    Automatic,  ///< when the points fill no more than surfaces (isSurfaceLike)
    Always
};

struct BulkInsertionOptions3d
{
    /// Class of the inserted vertices.
    VertexClass classification;
    ScaffoldPolicy scaffold = ScaffoldPolicy::None;
};

struct BulkInsertion3d
{
    /// Vertex of each input point; points at one place share the vertex of the first of them.
    std::vector<VertexId> vertex;
    std::uint32_t duplicates = 0;
    std::uint32_t scaffoldPoints = 0;
    /// Done, or Cancelled: then the points not reached have an invalid vertex and the triangulation is valid.
    StopReason stopReason = StopReason::Done;
};

enum class InsertionStatus : std::uint8_t
{
    Inserted,
    Duplicate,      ///< a vertex is there already
    OnConstraint,   ///< the point lies on a constrained face or edge, and the policy is not to split it
    NotStarShaped,  ///< see CavityStatus
    Blocked         ///< see CavityStatus::BlockedByConstraint
};

struct Insertion3d
{
    InsertionStatus status = InsertionStatus::Inserted;
    /// The new vertex, or the one that is there already.
    VertexId vertex;
    /// A tetrahedron at the vertex, a good hint for a next insertion nearby; invalid below dimension 3.
    TetId tet;
    /// Where the point lies, when it was not inserted.
    Location3d location;
};

/// What an insertion on a constrained face or edge does.
enum class ConstraintPolicy : std::uint8_t
{
    Refuse,
    Split  ///< a face into three, an edge and the faces at it into halves; the parts keep the constraint
};

enum class RemovalStatus : std::uint8_t
{
    Removed,
    OnConstraint,  ///< the vertex ends a constrained edge or face
    Blocked  ///< constraints nearby make the hole untriangulable by the Delaunay tetrahedra of its vertices
};

/// How often the rare paths were taken.
struct DelaunayCounters3d
{
    std::uint64_t cavityRepairs = 0;  ///< tetrahedra taken out of cavities to make them star-shaped
    std::uint64_t blockedInsertions = 0;
    std::uint64_t blockedRemovals = 0;
};

class VertexRemoval3d;

/// Error of a point that is not finite or out of the exact range; `name` says which point it is.
Result<void> checkPoint3d(const Vec3& point, std::string_view name);

/// The (constrained) Delaunay tetrahedralization of a changing point set, on exact predicates.
///
/// Guarantees   without constraints the Delaunay tetrahedralization under the symbolic perturbation of insphere.h, which
///              is unique: the same points give the same tetrahedra in whatever order they come (meshHash3d);
///              constraints are never lost (checkTopology3d). With them each unconstrained face stays locally Delaunay
///              (checkDelaunay3d) when removals and insertions without a repair alone change it, but for one case: a
///              face between the new vertex and an edge at which a constrained face ends and the cavity is reflex
/// Requires     points in the exact range (coordinate_range.h), else an Error; nothing else: duplicates, coplanar and
///              cospherical sets, and fewer than four points are ordinary input
/// Cost         bulk insertion n log n for usual sets; memory see Triangulation3d
/// Reference    [bowyer1981] [watson1981] [amenta2003] [devillers2011] [gosselin] §1.2.2
class Delaunay3d
{
public:
    explicit Delaunay3d(std::uint64_t seed = 1);
    ~Delaunay3d();
    Delaunay3d(const Delaunay3d&) = delete;
    Delaunay3d& operator=(const Delaunay3d&) = delete;

    /// -1 without points, 0 for one, 1 for collinear, 2 for coplanar points, 3 when there are tetrahedra.
    [[nodiscard]] int dimension() const { return dimension_; }

    /// Inserts many points at once. Errors: a point that is not finite or out of the exact range (named by its index;
    /// nothing is inserted then); constraints exist.
    Result<BulkInsertion3d> insertPoints(std::span<const Vec3> points, const BulkInsertionOptions3d& options,
                                         RunContext& context);

    /// Inserts one point. Errors: not finite or out of the exact range.
    Result<Insertion3d> insert(Vec3 point, TetId hint = {},
                               ConstraintPolicy policy = ConstraintPolicy::Refuse);

    /// Inserts one point as fast as can be. Requires a finite point in the exact range and inside a box that was
    /// announced by expectPointsIn, and no constraints; the vertices' incidentTet is not kept up.
    VertexId insertTrusted(const Vec3& point, VertexClass classification = {});
    void expectPointsIn(const Box3& box);

    /// Removes a vertex and restores the Delaunay property of what is left.
    RemovalStatus remove(VertexId vertex);

    /// Errors: as insert, and a triangulation of lower dimension.
    Result<Location3d> locate(Vec3 point, TetId hint = {});

    /// The cavity of a point in a located place, for callers that look before they insert; `commit` may follow
    /// as long as nothing else has changed.
    const Cavity3d& findCavity(Vec3 point, const Location3d& location, ConstraintPolicy policy);
    /// The same for a point that replaces facets, see CavityOperator3d::findForFacets.
    const Cavity3d& findCavity(Vec3 point, const CavitySplit3d& split);
    /// In two halves from one tetrahedron in conflict, for callers that look at the constraints in between.
    /// With more conflicts than `most` only the nearest to the seed are there (Cavity3d::isCut).
    const Cavity3d& findConflicts(Vec3 point, TetId seed,
                                  std::size_t most = std::numeric_limits<std::size_t>::max());
    const Cavity3d& makeStarShaped() { return cavities_.makeStarShaped(filter_); }
    /// The tetrahedra that the last commit or removal of this class made, ghosts included.
    [[nodiscard]] std::span<const TetId> created() const;
    /// The neighbours that the vertex of the last commit has, the ghost included.
    [[nodiscard]] std::span<const VertexId> neighboursOfCommitted() const { return cavities_.neighbours(); }
    /// Inserts the point of the cavity found last, whose status must be Ready.
    Insertion3d commit(VertexClass classification = {});

    [[nodiscard]] const Triangulation3d& triangulation() const { return mesh_; }
    /// For flips and constraints; the positions of vertices stay this class's own.
    [[nodiscard]] Triangulation3d& triangulation() { return mesh_; }
    [[nodiscard]] const StaticFilter3d& filter() const { return filter_; }
    [[nodiscard]] const DelaunayCounters3d& counters() const { return counters_; }
    /// Tetrahedra looked at to find and repair cavities, a measure of work that no clock has a part in.
    [[nodiscard]] std::uint64_t cavityWork() const { return cavities_.work(); }
    /// Back to no points; keeps the memory for the next ones.
    void clear();
    /// Renumbers without gaps; ids that the caller holds are mapped by the result.
    Renumbering3d compact();
    /// Bytes of the triangulation and all scratch memory.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct LexicographicallyLess
    {
        bool operator()(const Vec3& a, const Vec3& b) const { return isLexicographicallyLess(a, b); }
    };

    // below dimension 3: vertices wait until four of them span space
    VertexId insertPending(const Vec3& point, VertexClass classification);
    bool raisesDimension(const Vec3& point) const;
    void leavePendingState();
    void makeFirstTet();
    void enterPendingState();
    void removePending(VertexId vertex);

    TetId placeVertex(VertexId vertex);
    TetId startOfWalk(TetId hint) const;
    bool isOnConstraint(const Location3d& location) const;
    void reserveAfterSample(std::size_t remaining, std::size_t inserted);
    StopReason insertInOrder(std::span<const Vec3> points, std::span<const Vec3> scaffold,
                             const BulkInsertionOptions3d& options, RunContext& context,
                             BulkInsertion3d& result);

    Triangulation3d mesh_;
    CavityOperator3d cavities_;
    StaticFilter3d filter_;
    Box3 filterBox_;
    Random random_;
    int dimension_ = -1;
    TetId recent_;
    bool isRemovalLast_ = false;
    std::vector<TetId> seeds_;
    DelaunayCounters3d counters_;
    /// The vertices, by place, as long as they do not span space.
    std::map<Vec3, VertexId, LexicographicallyLess> pending_;
    /// dimension() + 1 affinely independent ones of them.
    std::vector<VertexId> basis_;
    std::unique_ptr<VertexRemoval3d> removal_;
};

}  // namespace mesher
