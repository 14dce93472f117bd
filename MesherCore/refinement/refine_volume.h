#pragma once

#include "base/budget.h"
#include "base/result.h"
#include "base/run_context.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_splitter.h"
#include "refinement/delaunay_refinement3d.h"
#include "refinement/left_places3d.h"

namespace mesher {

struct RefineVolumeOptions
{
    VolumeSizing sizing;
    TetQualityLimits quality;
    BoundaryPolicy boundary = BoundaryPolicy::Split;
    /// Segments and facets below it are not split, model units. DEFAULT: what the surface splitter allows
    double floor = 0.0;
    /// Segments with a vertex or segment nearer beside them than this are split for their length alone, model units: good
    /// tetrahedra between the two would be as small as the gap is wide, along all of them.
    double leastGap = 0.0;
    /// Tetrahedra that thin walls may take beyond the sizes wanted; see ThinWalls.
    double maxWallTets = 1e6;
    /// On the sides of walls that are kept flat whatever they take, ascending.
    std::vector<FlatWallFacet> flatFacets;
    /// Across narrow faces that are kept flat, ascending.
    std::vector<FlatStripFacet> flatStrips;
    /// The work after which a refinement that makes no headway ends, with the mesh that it has.
    WorkAllowance allowance;
    BudgetLimits limits;
};

struct RefinedVolume
{
    StopReason stopReason = StopReason::Done;
    RefinementCounts3d counts;
    std::uint64_t vertices = 0;  ///< of the tetrahedralization
    std::uint64_t tets = 0;      ///< of regions
    std::uint64_t leftForSmallAngles = 0;
    /// Tetrahedra of regions that are too large or bad still, each with the reason.
    std::vector<LeftTet3d> left;
    /// The same in groups, for people.
    std::vector<LeftPlace3d> places;
    /// Unconstrained faces of regions that are not locally Delaunay, each with the reason.
    std::vector<NonDelaunayFaces3d> nonDelaunayFaces;
    std::vector<ThinWall> walls;
    std::vector<NarrowGap> gaps;  ///< narrower than the least gap, beside which elements are left flat
    /// Set where the limits asked for were out of reach and the measure's own were kept in their place.
    std::optional<UnreachableQuality3d> unreachable;
    /// Whether it was ended since it made no headway any more, and where most of the work was done in vain then.
    bool hasStalled = false;
    std::vector<WorkLedger3d::Entry> costliest;
};

/// Refines the inside of a model to the sizes and the quality that are wanted, splitting its surface mesh along.
/// Guarantees   surface mesh and tetrahedralization agree (refinement_check.h), also when it ends early; the same input
///              gives the same mesh
/// Refuses      options out of range: InvalidArgument
/// Terminates   see refineDelaunay3d
/// Reference    [gosselin] chapter 4
Result<RefinedVolume> refineVolume(ConstrainedTetrahedralization& tetrahedralization,
                                   SurfaceSplitter& splitter, const RefineVolumeOptions& options,
                                   RunContext& context);

}  // namespace mesher
