#pragma once

#include "base/budget.h"
#include "tetrahedralization/constraint_split.h"
#include "tetrahedralization/facet_recovery.h"
#include "tetrahedralization/free_vertex_removal.h"
#include "tetrahedralization/segment_recovery.h"
#include "tetrahedralization/surface_vertex_lift.h"
#include "tetrahedralization/tetrahedralize.h"

namespace mesher {

/// Recovers all that is listed as missing: edges first, then facets, and again for what splits put in their place.
/// Errors       input that intersects itself
/// Terminates   always; when the vertices allowed are used up, the rest become failures; when cancelled, after the constraint
///              at hand
class ConstraintRecovery
{
public:
    ConstraintRecovery(SurfaceConstraints& constraints, const TetrahedralizationOptions& options,
                       Budget& budget, Tetrahedralization& result, RunContext& context);

    Result<void> run();

private:
    Result<void> recoverEdges();
    Result<void> recoverFacets();
    Result<bool> recoverEdge(const EdgeKey& edge, int depth);
    Result<bool> recoverFacet(FacetId facet, int depth, FacetEffort effort);
    Result<void> leaveTemporarySplits();
    bool lift(const TemporarySplits::Made& made);
    bool splitEdge(const EdgeKey& edge);
    bool splitFacet(FacetId facet);
    bool clearVertex(VertexId vertex);
    [[nodiscard]] bool isWanted(const EdgeKey& edge);
    [[nodiscard]] bool hasItsEdges(FacetId facet) const;
    [[nodiscard]] bool mayInsert() const;
    [[nodiscard]] bool mayGoOn();
    Error intersection(const std::string& name, const RecoveryObstacle& obstacle);
    void fail(const std::string& entity, const Vec3& kernelPoint, const std::string& what);
    void failAll();
    bool splitPierced(const RecoveryObstacle& obstacle);

    SurfaceConstraints& constraints_;
    const TetrahedralizationOptions& options_;
    Budget& budget_;
    Tetrahedralization& result_;
    RunContext& context_;
    FlipSearch flips_;
    SegmentRecovery segments_;
    FacetRecovery facets_;
    ConstraintSplit splits_;
    SurfaceVertexLift lifts_;
    FreeVertexRemover remover_;
    std::uint64_t tried_ = 0;
    std::uint64_t expected_ = 0;  ///< to be tried, at least
    std::uint64_t maxInserted_ = 0;
    std::uint64_t maxExact_ = 0;
};

}  // namespace mesher
