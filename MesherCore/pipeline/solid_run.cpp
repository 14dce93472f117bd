#include "pipeline/solid_run.h"

#include "pipeline/classify_solids.h"
#include "pipeline/estimate.h"
#include "pipeline/feature_sizes.h"
#include "pipeline/improve_solids.h"
#include "pipeline/left_elements.h"
#include "pipeline/left_triangles.h"
#include "pipeline/report_steps.h"
#include "pipeline/stage_counts.h"
#include "pipeline/stage_watch.h"
#include "pipeline/wall_budget.h"
#include "refinement/refine_volume.h"
#include "sizing/combined_size.h"
#include "surface_sampling/left_facets.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Tetrahedra that improvement tries, the worst first. An eighth of a mesh is below its target after refinement; where thin walls
/// and small angles leave far more, most cannot be helped.
std::uint64_t mostTries(std::size_t tets) { return 3 * static_cast<std::uint64_t>(tets) / 10 + 1000; }

/// Which walls are kept flat is decided on their surfaces; only what comes out far dearer than it was thought to be then is kept
/// flat in the volume after all.
constexpr double kUncertaintyOfWalls = 2.0;

/// Of the model's diagonal: what is nearer to an edge takes millions of good tetrahedra along each tenth of the diagonal.
constexpr double kLeastGapShare = 1e-7;

}  // namespace

SolidRun::SolidRun(const BrepModel& model, const MeshOptions& options,
                   std::shared_ptr<const SizingField> sizes, const WallBudget& budget, RunContext& context)
    : model_(model),
      options_(options),
      budget_(budget),
      context_(context),
      wishes_(std::move(sizes)),
      sizes_(wishes_)
{
    report().options = options;
}

bool SolidRun::sampleSurfaces()
{
    return isSampled_ = findSides() && findFeatures() && sample() && boundsVolumes();
}

const SurfaceMesh* SolidRun::surface() const { return isSampled_ ? &sample_.surface->mesh() : nullptr; }

MeshOutcome SolidRun::meshVolumes()
{
    if (isSampled_ && tetrahedralizeSample() && refine()) {
        context_.enterStage("classification");
        const bool isWhole = classify([&] {
            return classifySolids(tetrahedralization_.tets, sample_.surface->mesh(), sides_, context_);
        });
        if (isWhole && options_.isImproved && report().status == MeshReport::Status::Done) improve();
    }
    return outcome_.mesh ? std::move(outcome_) : keepSurface();
}

MeshOutcome SolidRun::keepSurface()
{
    if (sample_.surface) classify([&] { return classifySurface(sample_.surface->mesh(), sides_, context_); });
    return std::move(outcome_);
}

MeshOutcome SolidRun::meshFaces()
{
    if (findSides() && findFeatures() && sample()) {
        tellLeftTriangles(leftFacets(sample_.surface->faces()), report());
        return keepSurface();
    }
    return std::move(outcome_);
}

/// What there is when the time is over is made into a mesh without a limit, for those who want it.
template <class Classify>
bool SolidRun::classify(Classify make)
{
    if (context_.isCancelled()) {
        if (report().status != MeshReport::Status::Cancelled) tellStop(StopReason::Cancelled, report());
        return false;
    }
    const bool isTimeOver = report().stopReason == StopReason::TimeLimit;
    if (isTimeOver && !context_.keepsPartial()) return false;
    const StageWatch watch;
    ClassifiedMesh mesh;
    {
        const TimeLimitPause pause(context_, isTimeOver);
        mesh = make();
        if (const std::optional<StopReason> reason = context_.stopReason()) tellStop(*reason, report());
    }
    watch.addTo(report(), "classification");
    const bool isWhole = isTimeOver || report().stopReason != StopReason::TimeLimit;
    if (!isWhole || report().status == MeshReport::Status::Cancelled) return false;
    outcome_.mesh = std::move(mesh);
    return true;
}

bool SolidRun::findSides()
{
    Result<RegionSides> sides = regionSidesOf(model_);
    if (!sides) return failed(sides.error());
    sides_ = std::move(sides).value();
    return true;
}

SurfaceSamplingOptions SolidRun::samplingOfShape() const
{
    SurfaceSamplingOptions sampling;
    sampling.curves.maxVariation = std::min(options_.maxTurn, sampling.curves.maxVariation);
    sampling.facets.minAngle = options_.minAngle;
    sampling.limits.maxElements = options_.maxElements;
    sampling.walls.sides = &sides_;
    sampling.walls.maxTets = budget_.walls;
    sampling.walls.maxStripTets = budget_.strips;
    sampling.walls.leastSize = options_.minSize.value_or(0.0);
    return sampling;
}

/// Features are those of the shape, before any size makes its mesh finer.
bool SolidRun::findFeatures()
{
    if (!options_.refinement) return true;
    context_.enterStage("features");
    const StageWatch watch;
    SurfaceSamplingOptions sampling = samplingOfShape();
    sampling.walls.maxTets = wallBudgetOfFeatures(options_).walls;
    sampling.walls.maxStripTets = wallBudgetOfFeatures(options_).strips;
    const FeatureSizes features =
        featureSizes(model_, sides_, sampling, *options_.refinement, options_.grading, context_);
    watch.addTo(report(), "features");
    if (features.failure) return failed(*features.failure);
    if (!mayGoOn(features.stopReason)) return false;
    std::vector<std::shared_ptr<const SizingField>> fields = {features.field};
    if (wishes_) fields.push_back(wishes_);
    sizes_ = std::make_shared<CombinedSize>(std::move(fields), options_.minSize.value_or(0.0));
    return true;
}

bool SolidRun::sample()
{
    SurfaceSamplingOptions sampling = samplingOfShape();
    sampling.curves.sizes = sizes_.get();
    sampling.curves.segmentsPerTurn = options_.curvature;
    sampling.curves.maxSag = options_.sag;
    sampling.facets.elementsPerTurn = options_.curvature;
    sampling.facets.maxSag = options_.sag;
    sampling.facets.sizes = sizes_.get();
    sampling.facets.leastCurvatureSize = options_.minSize.value_or(0.0);
    context_.enterStage("surfaces");
    const StageWatch watch;
    Result<SurfaceSample> sampled = sampleSurface(model_, sampling, context_);
    watch.addTo(report(), "surfaces");
    if (!sampled) return failed(sampled.error());
    sample_ = std::move(sampled).value();
    tellCounts(sample_.counts, report());
    tellWalls(sample_.counts, report());
    tellUnreachableAngles(sample_.counts, report());
    for (const auto& [face, error] : sample_.failures) fail(report(), error);
    if (!sample_.failures.empty()) return false;
    if (mayGoOn(sample_.stopReason)) return true;
    if (sample_.stopReason == StopReason::ElementLimit) nameFaceOverLimit(sample_.surface->mesh(), report());
    return false;
}

/// Facets that intersect bound nothing; which faces they are on is known here.
bool SolidRun::boundsVolumes()
{
    for (const Error& error : sample_.counts.certificate.errors) fail(report(), error);
    return sample_.counts.certificate.errors.empty();
}

bool SolidRun::tetrahedralizeSample()
{
    TetrahedralizationOptions recovery;
    // Refinement puts vertices about where scaffold points are anyway, and their removal costs more than all the rest.
    recovery.scaffold = SurfaceScaffold::Kept;
    context_.enterStage("tetrahedralization");
    const StageWatch watch;
    Result<Tetrahedralization> made = tetrahedralize(*sample_.surface, sides_, recovery, context_);
    watch.addTo(report(), "tetrahedralization");
    if (!made) return failed(made.error());
    tetrahedralization_ = std::move(made).value();
    tellCounts(tetrahedralization_.counts, report());
    // What a limit left unrecovered is no fault of the model.
    if (!mayGoOn(tetrahedralization_.stopReason)) return false;
    for (const Error& error : tetrahedralization_.failures) fail(report(), error);
    return tetrahedralization_.failures.empty();
}

bool SolidRun::refine()
{
    RefineVolumeOptions refinement;
    refinement.sizing.usesLocalFeatureSize = false;
    refinement.sizing.usesFacetSides = true;
    refinement.sizing.grading = options_.grading;
    // Features are on the boundary, whose facets are as fine as they want: inside, sizes grow from there (thesis, section 4.4).
    refinement.sizing.field = wishes_.get();
    refinement.quality.measure = options_.measure;
    refinement.quality.threshold = options_.threshold;
    refinement.quality.largestDihedral = options_.maxDihedral;
    refinement.quality.lambda = options_.lambda;
    refinement.leastGap = kLeastGapShare * length(model_.box.extent());
    refinement.maxWallTets = kUncertaintyOfWalls * budget_.walls;
    refinement.flatFacets =
        facetsOnWalls(*sample_.surface, sides_, keptOf(sample_.counts.surveyedWalls), context_);
    refinement.flatStrips = facetsOnStrips(*sample_.surface);
    refinement.limits.maxElements = options_.maxElements;
    context_.enterStage("refinement");
    const StageWatch watch;
    Result<RefinedVolume> refined =
        refineVolume(tetrahedralization_.tets, *sample_.surface, refinement, context_);
    watch.addTo(report(), "refinement");
    if (!refined) return failed(refined.error());
    tellCounts(refined.value(), report());
    tellLeftElements(refined.value(), report());
    const StopReason reason = refined->stopReason;
    // Tetrahedra that stay bad, beside small angles of the shape for one, are told and do not fail the run.
    tellStop(reason == StopReason::CannotImprove ? StopReason::Done : reason, report());
    if (reason == StopReason::ElementLimit) nameWallOverLimit(refined.value(), report());
    return report().status != MeshReport::Status::Cancelled;
}

void SolidRun::improve()
{
    ImprovementOptions improvement;
    improvement.maxSag = options_.sag;
    improvement.limits.maxOperations = mostTries(outcome_.mesh->tets.size());
    context_.enterStage("improvement");
    const StageWatch watch;
    const Result<SolidImprovement> improved = improveSolids(*outcome_.mesh, model_, improvement, context_);
    watch.addTo(report(), "improvement");
    if (!improved) {
        failed(improved.error());
        return;
    }
    report().anglesBeforeImprovement = improved->improvement.anglesBefore;
    tellCounts(improved->improvement.counts, report());
    report().counts.emplace_back("frozen_boundaries", improved->isBoundaryFrozen ? 1 : 0);
    const StopReason reason = improved->improvement.stopReason;
    const bool isEnd = reason == StopReason::CannotImprove || reason == StopReason::OperationLimit;
    report().counts.emplace_back("improvement_cut_short", reason == StopReason::OperationLimit ? 1 : 0);
    tellStop(isEnd ? StopReason::Done : reason, report());
}

bool SolidRun::failed(Error error)
{
    fail(report(), std::move(error));
    return false;
}

bool SolidRun::mayGoOn(StopReason reason)
{
    if (reason == StopReason::Done || reason == StopReason::CannotImprove) return true;
    tellStop(reason, report());
    return false;
}

}  // namespace mesher
