#include "refinement/refine_volume.h"

#include "refinement/refinement_check.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mesher {

namespace {

Error outOfRange(const std::string& option, const std::string& range)
{
    return Error{ErrorCode::InvalidArgument, option + " is out of range", {}, {}, "choose " + range};
}

Result<void> validate(const RefineVolumeOptions& options)
{
    const auto isPositive = [](double x) { return std::isfinite(x) && x > 0.0; };
    if (!isPositive(options.sizing.refinement)) return outOfRange("refinement", "a number above 0");
    if (!isPositive(options.sizing.grading)) return outOfRange("grading", "a number above 0");
    if (!(options.maxWallTets >= 0.0)) return outOfRange("maximum of tetrahedra in walls", "0 or more");
    if (!std::isfinite(options.floor) || options.floor < 0.0) return outOfRange("floor", "0 or more");
    if (!std::isfinite(options.leastGap) || options.leastGap < 0.0)
        return outOfRange("least gap", "0 or more");
    const double best = infoOf(options.quality.measure).regularScore;
    const double threshold = options.quality.threshold.value_or(infoOf(options.quality.measure).threshold);
    if (!(threshold >= 0.0 && threshold < best)) {
        return outOfRange("threshold", "at least 0 and below the score of the regular tetrahedron");
    }
    if (!(options.quality.lambda.value_or(1.0) >= 1.0)) return outOfRange("lambda", "1 or more");
    const double largest = options.quality.largestDihedral.value_or(180.0);
    if (!(largest > 90.0 && largest <= 180.0))
        return outOfRange("largest dihedral angle", "90 to 180 degrees");
    return {};
}

std::uint64_t countMeshed(const Triangulation3d& mesh)
{
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (mesh.isAlive(tet) && !mesh.isGhostTet(tet) && mesh.region(tet) != kExteriorRegion) ++count;
    }
    return count;
}

}  // namespace

Result<RefinedVolume> refineVolume(ConstrainedTetrahedralization& tetrahedralization,
                                   SurfaceSplitter& splitter, const RefineVolumeOptions& options,
                                   RunContext& context)
{
    const Result<void> valid = validate(options);
    if (!valid) return valid.error();
    Budget budget(options.limits, context);
    // A wall is made good only as far as that leaves the run within its elements.
    const double room = static_cast<double>(options.limits.maxElements) -
                        static_cast<double>(countMeshed(tetrahedralization.mesh()));
    const double maxWallTets = std::clamp(room, 0.0, options.maxWallTets);
    DelaunayRefinement3d refinement =
        refineDelaunay3d(tetrahedralization, splitter,
                         {options.sizing, options.quality, options.boundary, options.floor, options.leastGap,
                          maxWallTets, options.flatFacets, options.flatStrips, options.allowance},
                         budget, context);
    if (context.checkLevel() == CheckLevel::Full) {
        MESHER_INVARIANT(checkRefinement(tetrahedralization, splitter.mesh()).isValid());
    }
    RefinedVolume result;
    result.stopReason = refinement.stopReason;
    result.counts = refinement.counts;
    result.left = std::move(refinement.left);
    result.nonDelaunayFaces = std::move(refinement.nonDelaunayFaces);
    result.walls = std::move(refinement.walls);
    result.gaps = std::move(refinement.gaps);
    result.unreachable = refinement.unreachable;
    result.hasStalled = refinement.hasStalled;
    result.costliest = std::move(refinement.costliest);
    result.places = groupLeftTets(tetrahedralization, result.left);
    const Triangulation3d& mesh = tetrahedralization.mesh();
    result.vertices = mesh.vertexCount();
    result.tets = countMeshed(mesh);
    // What was more from the start, and had nothing to be refined, has never asked the budget.
    const bool isEnded =
        result.stopReason == StopReason::Done || result.stopReason == StopReason::CannotImprove;
    if (isEnded && result.tets > options.limits.maxElements) result.stopReason = StopReason::ElementLimit;
    result.leftForSmallAngles = static_cast<std::uint64_t>(
        std::count_if(result.left.begin(), result.left.end(),
                      [](const LeftTet3d& t) { return t.reason == LeftReason3d::SmallInputAngle; }));
    context.reportProgress("refinement", 1.0);
    return result;
}

}  // namespace mesher
