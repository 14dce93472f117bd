#pragma once

#include "base/budget.h"
#include "base/error.h"
#include "base/result.h"
#include "base/run_context.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/region_sides.h"
#include "mesh/surface_splitter.h"

#include <cstdint>
#include <vector>

namespace mesher {

enum class SurfaceScaffold : std::uint8_t
{
    None,
    Automatic,  ///< scaffold points for large surface meshes (scaffold.h); those inside of solids are removed again
    Kept  ///< the same, but they stay as vertices of the inside: the fastest way to a mesh that is to be refined anyway
};

struct TetrahedralizationOptions
{
    SurfaceScaffold scaffold = SurfaceScaffold::Automatic;
    /// Levels of edges that a flip may remove first to remove another. Range 0 to 3; more finds more, at exponential cost.
    int flipDepth = 2;
    /// Vertices that recovery may insert, as a share of the nodes, and 1000 besides. Range 0 to 10.
    double maxInsertedShare = 0.5;
    BudgetLimits limits;  ///< operations are recoveries tried
};

/// What was met and what was done, for reports.
struct TetrahedralizationCounts
{
    std::uint32_t nodes = 0;
    std::uint32_t scaffoldPoints = 0;
    std::uint32_t boxPoints = 0;
    std::uint32_t missingEdges =
        0;  ///< of the Delaunay tetrahedralization, segments and edges of missing facets
    std::uint32_t missingFacets = 0;
    std::uint32_t edgesByFlips = 0;
    std::uint32_t facetsByFlips = 0;
    std::uint32_t facetsByCavity = 0;
    std::uint32_t facetsByStar = 0;
    std::uint32_t attempts = 1;     ///< at the recovery, in different orders
    std::uint32_t exactSplits = 0;  ///< new nodes on the exact geometry
    std::uint32_t temporarySplits =
        0;  ///< off the exact geometry, taken back but for those counted in the next two
    std::uint32_t edgeSteiner = 0;   ///< new nodes on edges that are not on the exact geometry
    std::uint32_t facetSteiner = 0;  ///< … on facets
    std::uint32_t starVertices = 0;  ///< additional vertices off the surface, before removal
    std::uint32_t freeVerticesLeft =
        0;  ///< scaffold and additional vertices inside of solids that could not be removed
    std::uint64_t recoveryFlips = 0;
    std::uint64_t delaunayFlips = 0;
    std::uint64_t delaunayCavities = 0;  ///< cavities filled anew where flips were stuck
    std::uint64_t nonDelaunayFaces =
        0;  ///< at the end, inside of solids: faces with a vertex strictly inside of the sphere beside
};

struct Tetrahedralization
{
    ConstrainedTetrahedralization tets;
    TetrahedralizationCounts counts;
    /// Constraints that were not recovered, by entity and place; without any, the guarantees hold.
    std::vector<Error> failures;
    /// Done; CannotImprove if there are failures; or the limit that was hit.
    StopReason stopReason = StopReason::Done;
};

/// Builds the constrained Delaunay tetrahedralization of a closed piecewise linear complex: nodes, missing constraints, their
/// recovery by flips, by splits on the exact geometry, by cavities and by Steiner points, flips to the constrained Delaunay
/// property, regions.
///
/// Guarantees   without failures each live segment and facet of the splitter's mesh is a constrained edge or face
///              (checkConstraints) and each region is that of its faces' sides (checkRegions); the hull is a box around the
///              model, whose corners are scaffold vertices as are those left outside of the solids
/// Requires     a mesh whose segments and facets meet in their nodes only. Errors: nodes at one place (DuplicatePoint),
///              segments and facets that cross (IntersectingConstraints), facets without area (DegenerateInput), sides
///              that contradict each other (InvalidArgument); each names the entities and the point
/// Terminates   always: the vertices that may be inserted are limited (maxInsertedShare)
/// Cost         n log n for the nodes, then proportional to the faces, and to what is missing
/// Reference    [gosselin] §3.3.3; [si2005], [si2015], [george1991]
Result<Tetrahedralization> tetrahedralize(SurfaceSplitter& surface, const RegionSides& sides,
                                          const TetrahedralizationOptions& options, RunContext& context);

/// The same without exact geometry: the mesh gets Steiner points where nothing else helps.
Result<Tetrahedralization> tetrahedralize(SurfaceMesh& surface, const RegionSides& sides,
                                          const TetrahedralizationOptions& options, RunContext& context);

}  // namespace mesher
