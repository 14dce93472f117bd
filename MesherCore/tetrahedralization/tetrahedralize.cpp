#include "tetrahedralization/tetrahedralize.h"

#include "delaunay/constrained_check.h"
#include "delaunay/constrained_flips3d.h"
#include "delaunay/delaunay_check3d.h"
#include "tetrahedralization/constraint_recovery.h"
#include "tetrahedralization/free_vertex_removal.h"
#include "tetrahedralization/linear_splitter.h"
#include "tetrahedralization/missing_constraints.h"
#include "tetrahedralization/node_insertion.h"
#include "tetrahedralization/region_classification.h"
#include "tetrahedralization/surface_input.h"

namespace mesher {

namespace {

Result<void> checkOptions(const TetrahedralizationOptions& options)
{
    if (options.flipDepth < 0 || options.flipDepth > 3)
        return Error{ErrorCode::InvalidArgument, "flipDepth is not from 0 to 3", {}, {}, {}};
    if (!(options.maxInsertedShare >= 0.0 && options.maxInsertedShare <= 10.0))
        return Error{ErrorCode::InvalidArgument, "maxInsertedShare is not from 0 to 10", {}, {}, {}};
    return {};
}

Result<void> recover(SurfaceSplitter& surface, const TetrahedralizationOptions& options, Budget& budget,
                     Tetrahedralization& result)
{
    SurfaceConstraints constraints(surface, result.tets);
    findMissingConstraints(constraints);
    result.counts.missingEdges = static_cast<std::uint32_t>(constraints.missingEdges.size());
    result.counts.missingFacets = static_cast<std::uint32_t>(constraints.missingFacets.size());
    ConstraintRecovery recovery(constraints, options, budget, result);
    const Result<void> recovered = recovery.run();
    constraints.releaseTemporaryLocks();
    return recovered;
}

void restoreDelaunay(Budget& budget, Tetrahedralization& result)
{
    ConstrainedFlips3d flips(*result.tets.delaunay, DelaunayPart::Everywhere);
    flips.pushAll();
    flips.flipAndFill(budget);
    result.counts.delaunayFlips += flips.counts().flips;
    result.counts.delaunayCavities += flips.counts().cavities;
}

/// Each full check costs a good part of the stage.
void checkResult(const SurfaceMesh& surface, const RegionSides& sides, const Tetrahedralization& result,
                 const RunContext& context)
{
    if (context.checkLevel() != CheckLevel::Full) return;
    const bool isSound = checkTopology3d(result.tets.mesh()).isValid() &&
                         checkConstraints(result.tets, surface).isValid() &&
                         checkRegions(result.tets, surface, sides).isValid();
    if (!isSound) context.log(LogLevel::Warning, "the tetrahedralization breaks its guarantees");
}

}  // namespace

Result<Tetrahedralization> tetrahedralize(SurfaceSplitter& surface, const RegionSides& sides,
                                          const TetrahedralizationOptions& options, RunContext& context)
{
    if (Result<void> valid = checkOptions(options); !valid) return valid.error();
    if (Result<void> valid = checkSurfaceInput(surface.mesh(), sides); !valid) return valid.error();
    Tetrahedralization result;
    Budget budget(options.limits, context);
    if (Result<void> inserted = insertNodes(surface.mesh(), options, context, result); !inserted)
        return inserted.error();
    if (result.stopReason != StopReason::Done) return result;
    if (Result<void> recovered = recover(surface, options, budget, result); !recovered)
        return recovered.error();
    if (!result.failures.empty() || result.stopReason != StopReason::Done) return result;
    restoreDelaunay(budget, result);
    if (Result<void> regions = classifyRegions(result.tets, surface.mesh(), sides); !regions)
        return regions.error();
    const FreeVertexRemoval removal = removeFreeVertices(result.tets, options.scaffold);
    result.counts.freeVerticesLeft = removal.left;
    if (removal.removed > 0) restoreDelaunay(budget, result);
    result.counts.nonDelaunayFaces = countNonDelaunayFaces(result.tets.mesh(), DelaunayPart::Inside);
    result.stopReason = budget.stopReason();
    checkResult(surface.mesh(), sides, result, context);
    return result;
}

Result<Tetrahedralization> tetrahedralize(SurfaceMesh& surface, const RegionSides& sides,
                                          const TetrahedralizationOptions& options, RunContext& context)
{
    LinearSplitter splitter(surface);
    return tetrahedralize(splitter, sides, options, context);
}

}  // namespace mesher
