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

#include <algorithm>

namespace mesher {

namespace {

/// At a recovery that fails at points of its own.
constexpr std::uint32_t kMostAttempts = 3;

Result<void> checkOptions(const TetrahedralizationOptions& options)
{
    if (options.flipDepth < 0 || options.flipDepth > 3)
        return Error{ErrorCode::InvalidArgument, "flipDepth is not from 0 to 3", {}, {}, {}};
    if (!(options.maxInsertedShare >= 0.0 && options.maxInsertedShare <= 10.0))
        return Error{ErrorCode::InvalidArgument, "maxInsertedShare is not from 0 to 10", {}, {}, {}};
    return {};
}

/// `mayTryAgain`: points that recovery made up may be what it failed at, not the input.
Result<void> recover(SurfaceSplitter& surface, const TetrahedralizationOptions& options, Budget& budget,
                     RunContext& context, Tetrahedralization& result, bool& mayTryAgain)
{
    SurfaceConstraints constraints(surface, result.tets);
    findMissingConstraints(constraints);
    result.counts.missingEdges = static_cast<std::uint32_t>(constraints.missingEdges.size());
    result.counts.missingFacets = static_cast<std::uint32_t>(constraints.missingFacets.size());
    // Another order meets other special positions.
    if (result.counts.attempts % 2 == 0)
        std::reverse(constraints.missingEdges.begin(), constraints.missingEdges.end());
    ConstraintRecovery recovery(constraints, options, budget, result, context);
    const Result<void> recovered = recovery.run();
    mayTryAgain = constraints.temporarySplits() != nullptr && budget.allows();
    constraints.releaseTemporaryLocks();
    return recovered;
}

void restoreDelaunay(Budget& budget, RunContext& context, Tetrahedralization& result)
{
    context.reportProgress("constrained Delaunay", 0.0);
    ConstrainedFlips3d flips(*result.tets.delaunay, DelaunayPart::Everywhere);
    flips.pushAll(budget);
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
    for (std::uint32_t attempt = 1;; ++attempt) {
        result = {};
        result.counts.attempts = attempt;
        if (Result<void> inserted = insertNodes(surface.mesh(), options, context, result); !inserted)
            return inserted.error();
        if (result.stopReason != StopReason::Done) return result;
        bool mayTryAgain = false;
        const Result<void> recovered = recover(surface, options, budget, context, result, mayTryAgain);
        if (recovered && result.failures.empty()) break;
        if (mayTryAgain && attempt < kMostAttempts) continue;
        if (!recovered) return recovered.error();
        break;
    }
    if (!result.failures.empty() || result.stopReason != StopReason::Done) return result;
    restoreDelaunay(budget, context, result);
    if (Result<void> regions = classifyRegions(result.tets, surface.mesh(), sides); !regions)
        return regions.error();
    const FreeVertexRemoval removal = removeFreeVertices(result.tets, options.scaffold, budget, context);
    result.counts.freeVerticesLeft = removal.left;
    if (removal.removed > 0) restoreDelaunay(budget, context, result);
    result.stopReason = budget.stopReason();
    if (result.stopReason != StopReason::Done) return result;
    result.counts.nonDelaunayFaces = countNonDelaunayFaces(result.tets.mesh(), DelaunayPart::Inside);
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
