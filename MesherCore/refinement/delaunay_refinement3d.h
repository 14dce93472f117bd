#pragma once

#include "base/budget.h"
#include "base/run_context.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_splitter.h"
#include "refinement/boundary_split3d.h"
#include "refinement/flat_strips.h"
#include "refinement/length_scale3d.h"
#include "refinement/narrow_gaps.h"
#include "refinement/refinement_criteria.h"
#include "refinement/small_angle_guard.h"
#include "refinement/thin_walls.h"
#include "refinement/work_ledger3d.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

enum class BoundaryPolicy : std::uint8_t
{
    Split,  ///< curves and facets are split where they are encroached or too large
    Frozen  ///< the surface mesh stays as it is
};

struct RefinementCounts3d
{
    std::uint64_t sinkInsertions =
        0;  ///< of tetrahedra with their own circumcentre, before the boundary is touched
    std::uint64_t sizeInsertions = 0;     ///< of tetrahedra that are too large
    std::uint64_t qualityInsertions = 0;  ///< of tetrahedra that are bad
    std::uint64_t segmentSplits = 0;
    std::uint64_t facetSplits = 0;
    std::uint64_t rejectedCentres = 0;  ///< circumcentres that would have encroached upon the boundary
    std::uint64_t refusedSegments = 0;  ///< not split: limits, or no way to
    std::uint64_t refusedFacets = 0;
    std::uint64_t guardedSplits = 0;      ///< not made beside small angles, as they would make shorter edges
    std::uint64_t neighbourSplits = 0;    ///< facets split in the place of one that could not be
    std::uint64_t shortInsertions = 0;    ///< at or before a boundary that cannot be split
    std::uint64_t abortedInsertions = 0;  ///< no cavity around the circumcentre was star-shaped
    std::uint64_t flatTets = 0;           ///< so flat that the circumcentre of a face had to do
    std::uint64_t cavityRepairs = 0;      ///< tetrahedra taken out of cavities to make them star-shaped
    std::uint64_t delaunayFlips = 0;      ///< after splits and repairs, and at the end
    std::uint64_t delaunayCavities = 0;   ///< filled anew at the end where flips were stuck
    std::uint64_t facetSwaps = 0;         ///< of the diagonal of two facets
    std::uint64_t bentSwaps = 0;          ///< of these, of facets off one plane, which move the surface
    std::uint64_t stubbornTets = 0;       ///< that were made to give way at the end, see StubbornTets
    std::uint64_t heldBackTets = 0;       ///< that lambda left at first, and were tried again with it lifted
    std::uint64_t liftedInsertions = 0;   ///< of circumcentres with lambda lifted
    std::uint64_t outsideVertices = 0;    ///< added outside of the solids so that facets could be swapped
    std::uint64_t nonDelaunayFaces = 0;   ///< left: unconstrained, inside of the solids
    BoundarySplitCounts boundary;
};

/// Why a tetrahedron stayed bad.
enum class LeftReason3d : std::uint8_t
{
    SmallInputAngle,  ///< beside `angle`
    ThinWall,         ///< in or beside a wall that is kept flat, between the faces in `entity` and `other`
    NarrowFace,       ///< beside the face in `entity`, which is kept flat
    LengthScale,      ///< further refinement would go too far below the length scale
    Boundary,         ///< an entity beside it may not or cannot be split any further
    Resolution,       ///< no cavity, or no place for a vertex in double arithmetic
    NoHeadway,        ///< the run ended since too much was done in vain, mostly beside `entity` and `other`
    Unfinished        ///< the run was ended before
};

struct LeftTet3d
{
    TetId tet;
    LeftReason3d reason = LeftReason3d::Unfinished;
    std::optional<SmallInputAngle> angle;
    EntityRef entity;  ///< in the way, or that a corner is on, or the solid; none where nothing was tried
    EntityRef other;   ///< the second face of a wall
};

/// Why a face was left that is not locally Delaunay.
enum class NonDelaunayReason3d : std::uint8_t
{
    Tie,          ///< five vertices are on one sphere to within rounding
    Boundary,     ///< flips would need the surface at `entity` to be flipped with them
    Interlocked,  ///< inside, flips keep each other from being made
    Unfinished    ///< flips and refinement did not agree within their rounds
};

/// Unconstrained faces that were left for one reason at one place.
struct NonDelaunayFaces3d
{
    NonDelaunayReason3d reason = NonDelaunayReason3d::Unfinished;
    std::array<EntityRef, 2>
        entity;  ///< that keeps them from being flipped; those that are not known stand at the end
    std::uint64_t count = 0;
    Vec3 place;  ///< centroid of one of them, model units
};

struct DelaunayRefinementOptions3d
{
    VolumeSizing sizing;
    TetQualityLimits quality;
    BoundaryPolicy boundary = BoundaryPolicy::Split;
    /// Segments and facets below it are not split, model units; 0 leaves it to the surface splitter.
    double floor = 0.0;
    /// Segments with a vertex or segment nearer beside them than this are split for their length alone, model units.
    double leastGap = 0.0;
    /// Tetrahedra that thin walls may take beyond the sizes wanted. Walls that take more are left with flat ones.
    double maxWallTets = 1e6;
    /// On the sides of walls that are kept flat whatever they take, ascending.
    std::vector<FlatWallFacet> flatFacets;
    /// Across narrow faces that are kept flat, ascending.
    std::vector<FlatStripFacet> flatStrips;
    /// The work after which a refinement that makes no headway ends.
    WorkAllowance allowance;
};

/// Limits of quality that more vertices did not bring nearer.
struct UnreachableQuality3d
{
    double best = 0.0;       ///< about the highest score that all tetrahedra had at one time
    std::uint64_t bad = 0;   ///< tetrahedra beyond the limits when these were given up
    std::uint64_t tets = 0;  ///< of regions, then
};

struct DelaunayRefinement3d
{
    /// Done; CannotImprove when tetrahedra are left bad; or the limit that ended it.
    StopReason stopReason = StopReason::Done;
    RefinementCounts3d counts;
    std::vector<LeftTet3d> left;
    std::vector<NonDelaunayFaces3d> nonDelaunayFaces;
    std::vector<ThinWall> walls;
    std::vector<NarrowGap> gaps;  ///< too narrow to split segments beside them for more than their length
    /// Set where the limits asked for were out of reach and the measure's own were kept in their place.
    std::optional<UnreachableQuality3d> unreachable;
    /// Whether the allowance of work has ended it, and where most of the work was done in vain then.
    bool hasStalled = false;
    std::vector<WorkLedger3d::Entry> costliest;
};

/// Refines a constrained Delaunay tetrahedralization until every tetrahedron of a region has the size and the quality that
/// is wanted: segments before facets before tetrahedra, the worst first.
/// Guarantees   constraints, maps and regions agree with the surface mesh at any time (refinement_check.h)
/// Terminates   with a field that is bounded from below: no entity is split far below its length scale. Where too much is
///              tried in vain the allowance of work ends it, the same on every machine; the budget does in any case
/// Reference    [gosselin] sections 4.3 and 4.7.2
DelaunayRefinement3d refineDelaunay3d(ConstrainedTetrahedralization& tetrahedralization,
                                      SurfaceSplitter& splitter, const DelaunayRefinementOptions3d& options,
                                      Budget& budget, RunContext& context);

}  // namespace mesher
