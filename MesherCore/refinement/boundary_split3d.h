#pragma once

#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_splitter.h"
#include "refinement/encroachment3d.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace mesher {

enum class SplitOutcome3d : std::uint8_t
{
    Split,
    EncroachesSegment,  ///< the new vertex would lie in the ball of a segment, which is to be split first
    TooSmall,           ///< below the floor of the model's tolerance
    NotFound,           ///< the exact surface has no point for it, or none that fits its neighbours
    NotStarShaped       ///< no cavity around the new vertex sees it on both sides of the surface
};

struct BoundarySplit3d
{
    SplitOutcome3d outcome = SplitOutcome3d::NotFound;
    SegmentId encroached;
    VertexId vertex;                 ///< the new one
    std::vector<VertexId> surround;  ///< its neighbours on the segment or on the new facets
};

/// How often the rare paths of boundary splits were taken.
struct BoundarySplitCounts
{
    std::uint64_t deletedVertices = 0;
    std::uint64_t keptVertices = 0;        ///< in the ball of what was split, and could not be deleted
    std::uint64_t leastExtents = 0;        ///< splits made with the least change of the surface
    std::uint64_t blockedCavities = 0;     ///< evaluated splits that no cavity could take
    std::uint64_t cutCavities = 0;         ///< that did not take in all conflicts, being too many
    std::uint64_t inconsistentSplits = 0;  ///< of the surface, that do not fit the tetrahedralization
};

/// Splits segments and facets of a constrained tetrahedralization at points of the exact geometry, which need not lie in
/// the facets that they replace.
/// Guarantees   either nothing has changed but interior vertices deleted, or surface mesh, constraints, maps and regions
///              agree again (refinement_check.h); interior vertices in the ball of what is split are deleted as far as
///              the tetrahedralization lets them
/// Reference    [gosselin] sections 4.3 and 4.7.2
class BoundarySplitter3d
{
public:
    BoundarySplitter3d(ConstrainedTetrahedralization& tetrahedralization, SurfaceSplitter& splitter);

    /// `mayEncroach` tells segments that cannot be split, so that they cannot be waited for.
    BoundarySplit3d splitFacet(FacetId facet, const std::function<bool(SegmentId)>& mayEncroach);
    BoundarySplit3d splitSegment(SegmentId segment);

    /// All tetrahedra that the last split and its deletions have made; some may be gone again.
    [[nodiscard]] const std::vector<TetId>& created() const { return created_; }
    /// What the last split has put into the surface mesh; valid if it was made.
    [[nodiscard]] const SurfaceSplitResult& made() const { return made_; }
    [[nodiscard]] const BoundarySplitCounts& counts() const { return counts_; }

private:
    using Face = std::array<VertexId, 3>;
    using Edge = std::array<VertexId, 2>;

    bool prepare();
    const Cavity3d& findCavity();
    SegmentId encroachedSegment(const Cavity3d& cavity,
                                const std::function<bool(SegmentId)>& mayEncroach) const;
    bool deleteVerticesIn(const Cavity3d& cavity, const ProtectingBall& ball);
    bool isCavityReady(const ProtectingBall& ball);
    bool commitIfReady(const ProtectingBall& ball, SurfaceSplitExtent extent, BoundarySplit3d& result);
    void commit(BoundarySplit3d& split);
    [[nodiscard]] VertexId vertexOf(NodeId node) const { return t_.vertexOf[node]; }
    [[nodiscard]] Face cornersOf(const SurfaceFacet& facet) const;

    ConstrainedTetrahedralization& t_;
    SurfaceSplitter& splitter_;
    SurfaceSplit split_;
    SurfaceSplitResult made_;
    std::vector<Face> faces_;
    std::vector<Edge> perimeter_;
    std::vector<Edge> boundary_;
    std::array<VertexId, 3> edge_;
    std::vector<VertexId> inBall_;
    std::vector<TetId> created_;
    BoundarySplitCounts counts_;
};

}  // namespace mesher
