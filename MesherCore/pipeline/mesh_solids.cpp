#include "pipeline/mesh_solids.h"

#include "brep/face_area.h"
#include "brep/solid_volume.h"
#include "mesh/region_sides.h"
#include "pipeline/classify_solids.h"
#include "pipeline/component_contacts.h"
#include "pipeline/estimate_solids.h"
#include "pipeline/improve_solids.h"
#include "pipeline/left_elements.h"
#include "pipeline/model_components.h"
#include "pipeline/report_steps.h"
#include "pipeline/solid_sizes.h"
#include "pipeline/wall_estimate.h"
#include "refinement/refine_volume.h"
#include "surface_sampling/sample_surface.h"
#include "tetrahedralization/tetrahedralize.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Tetrahedra that improvement tries, the worst first. An eighth of a mesh is below its target after refinement; where thin walls
/// and small angles leave far more, most cannot be helped.
std::uint64_t mostTries(std::size_t tets) { return 3 * static_cast<std::uint64_t>(tets) / 10 + 1000; }

using Clock = std::chrono::steady_clock;

constexpr double kReportedUncertainty = 1e-4;  // of the model's volume, relative
constexpr double kLargestMinAngle = 34.0;      // degrees, see FacetCriteriaOptions

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Error notYet(const char* option, const char* what)
{
    return {ErrorCode::InvalidArgument, what, option, {}, "leave the option out"};
}

/// Meshes one component: each step returns whether the next one may follow.
class SolidRun
{
public:
    SolidRun(const BrepModel& model, const MeshOptions& options, std::shared_ptr<const SizingField> sizes,
             RunContext& context, Clock::time_point start)
        : model_(model), options_(options), context_(context), start_(start), sizes_(std::move(sizes))
    {
        report().options = options;
    }

    /// The first half, after which solids can be compared with those of other groups.
    bool sampleSurfaces() { return isSampled_ = findSides() && sample() && boundsVolumes(); }

    [[nodiscard]] const SurfaceMesh* surface() const
    {
        return isSampled_ ? &sample_.surface->mesh() : nullptr;
    }
    [[nodiscard]] const RegionSides& sides() const { return sides_; }

    MeshOutcome meshVolumes()
    {
        if (isSampled_ && canFillWalls() && tetrahedralizeSample() && refine()) {
            outcome_.mesh = classifySolids(tetrahedralization_.tets, sample_.surface->mesh(), sides_);
            if (options_.isImproved && report().status == MeshReport::Status::Done) improve();
        }
        return outcome_.mesh ? std::move(outcome_) : keepSurface();
    }

    /// What there is of a run that goes no further.
    MeshOutcome keepSurface()
    {
        if (sample_.surface && report().status != MeshReport::Status::Cancelled)
            outcome_.mesh = classifySurface(sample_.surface->mesh(), sides_);
        return std::move(outcome_);
    }

    MeshOutcome meshFaces()
    {
        if (findSides() && sample()) outcome_.mesh = classifySurface(sample_.surface->mesh(), sides_);
        return std::move(outcome_);
    }

private:
    [[nodiscard]] MeshReport& report() { return outcome_.report; }

    bool failed(Error error)
    {
        fail(report(), std::move(error));
        return false;
    }

    bool findSides()
    {
        Result<RegionSides> sides = regionSidesOf(model_);
        if (!sides) return failed(sides.error());
        sides_ = std::move(sides).value();
        return true;
    }

    bool sample()
    {
        SurfaceSamplingOptions sampling;
        sampling.curves.sizes = sizes_.get();
        sampling.curves.segmentsPerTurn = options_.curvature;
        sampling.curves.maxSag = options_.sag;
        sampling.curves.maxVariation = std::min(options_.maxTurn, sampling.curves.maxVariation);
        sampling.facets.minAngle = options_.minAngle;
        sampling.facets.elementsPerTurn = options_.curvature;
        sampling.facets.maxSag = options_.sag;
        sampling.facets.sizes = sizes_.get();
        sampling.facets.leastCurvatureSize = options_.minSize.value_or(0.0);
        sampling.limits.maxTime = timeLeft();
        sampling.limits.maxElements = options_.maxElements;
        const Clock::time_point start = Clock::now();
        Result<SurfaceSample> sampled = sampleSurface(model_, sampling, context_);
        addSeconds("surfaces", start);
        if (!sampled) return failed(sampled.error());
        sample_ = std::move(sampled).value();
        tellSample();
        for (const auto& [face, error] : sample_.failures) fail(report(), error);
        if (!sample_.failures.empty()) return false;
        return mayGoOn(sample_.stopReason);
    }

    /// Facets that intersect bound nothing; which faces they are on is known here.
    bool boundsVolumes()
    {
        for (const Error& error : sample_.counts.certificate.errors) fail(report(), error);
        return sample_.counts.certificate.errors.empty();
    }

    void tellSample()
    {
        const SurfaceSamplingCounts& counts = sample_.counts;
        add("curve_vertices", counts.curveNodes);
        add("initial_surface_vertices", counts.initialVertices);
        add("sample_vertices", counts.vertices);
        add("sample_facets", counts.facets);
        add("sample_segments", counts.segments);
    }

    bool canFillWalls()
    {
        const WallEstimate walls = estimateWalls(sample_.surface->mesh(), sides_);
        if (walls.elements <= mostExpectedElements(options_)) return true;
        std::ostringstream message;
        message.precision(3);
        message << "the wall behind it is " << walls.thickness << " thick, and about " << walls.elements
                << " elements would be needed in walls so thin, more than --max-elements "
                << options_.maxElements;
        return failed({ErrorCode::OutOfRange, message.str(), nameOf(walls.face), walls.place,
                       "thicken the wall, mesh a face of it with --dimension 2, or raise --max-elements"});
    }

    bool tetrahedralizeSample()
    {
        TetrahedralizationOptions recovery;
        recovery.limits.maxTime = timeLeft();
        const Clock::time_point start = Clock::now();
        Result<Tetrahedralization> made = tetrahedralize(*sample_.surface, sides_, recovery, context_);
        addSeconds("tetrahedralization", start);
        if (!made) return failed(made.error());
        tetrahedralization_ = std::move(made).value();
        tellRecovery();
        // What a limit left unrecovered is no fault of the model.
        if (!mayGoOn(tetrahedralization_.stopReason)) return false;
        for (const Error& error : tetrahedralization_.failures) fail(report(), error);
        return tetrahedralization_.failures.empty();
    }

    void tellRecovery()
    {
        const TetrahedralizationCounts& counts = tetrahedralization_.counts;
        add("missing_edges", counts.missingEdges);
        add("missing_facets", counts.missingFacets);
        add("recovery_splits", counts.exactSplits);
        add("recovery_vertices", counts.edgeSteiner + counts.facetSteiner + counts.freeVerticesLeft);
        add("scaffold_vertices", counts.scaffoldPoints);
        add("non_delaunay_faces", counts.nonDelaunayFaces);
    }

    bool refine()
    {
        RefineVolumeOptions refinement;
        refinement.sizing.usesLocalFeatureSize = false;
        refinement.sizing.refinement = options_.refinement;
        refinement.sizing.grading = options_.grading;
        refinement.sizing.field = sizes_.get();
        refinement.quality.measure = options_.measure;
        refinement.quality.threshold = options_.threshold;
        refinement.maxWallTets = static_cast<double>(options_.maxWallElements);
        refinement.limits.maxElements = options_.maxElements;
        refinement.limits.maxTime = timeLeft();
        const Clock::time_point start = Clock::now();
        Result<RefinedVolume> refined =
            refineVolume(tetrahedralization_.tets, *sample_.surface, refinement, context_);
        addSeconds("refinement", start);
        if (!refined) return failed(refined.error());
        tellRefinement(refined.value());
        const StopReason reason = refined->stopReason;
        // Tetrahedra that stay bad, beside small angles of the shape for one, are told and do not fail the run.
        tellStop(reason == StopReason::CannotImprove ? StopReason::Done : reason, report());
        return report().status != MeshReport::Status::Cancelled;
    }

    void tellRefinement(const RefinedVolume& refined)
    {
        const RefinementCounts3d& counts = refined.counts;
        add("sink_insertions", counts.sinkInsertions);
        add("size_insertions", counts.sizeInsertions);
        add("quality_insertions", counts.qualityInsertions);
        add("segment_splits", counts.segmentSplits);
        add("facet_splits", counts.facetSplits);
        add("cavity_repairs", counts.cavityRepairs);
        add("aborted_insertions", counts.abortedInsertions);
        add("refused_segments", counts.refusedSegments);
        add("refused_facets", counts.refusedFacets);
        add("delaunay_flips", counts.delaunayFlips);
        add("delaunay_cavities", counts.delaunayCavities);
        add("facet_swaps", counts.facetSwaps);
        add("non_delaunay_faces_left", counts.nonDelaunayFaces);
        add("tets_left", refined.left.size());
        add("tets_left_beside_small_angles", refined.leftForSmallAngles);
        tellLeftElements(refined, report());
    }

    void improve()
    {
        ImprovementOptions improvement;
        improvement.maxSag = options_.sag;
        improvement.limits.maxTime = timeLeft();
        improvement.limits.maxOperations = mostTries(outcome_.mesh->tets.size());
        const Clock::time_point start = Clock::now();
        const Result<SolidImprovement> improved =
            improveSolids(*outcome_.mesh, model_, improvement, context_);
        addSeconds("improvement", start);
        if (!improved) {
            failed(improved.error());
            return;
        }
        tellImprovement(improved->improvement);
        add("frozen_boundaries", improved->isBoundaryFrozen ? 1 : 0);
        const StopReason reason = improved->improvement.stopReason;
        const bool isEnd = reason == StopReason::CannotImprove || reason == StopReason::OperationLimit;
        add("improvement_cut_short", reason == StopReason::OperationLimit ? 1 : 0);
        tellStop(isEnd ? StopReason::Done : reason, report());
    }

    void tellImprovement(const Improvement& improved)
    {
        const ImprovementCounts& counts = improved.counts;
        report().anglesBeforeImprovement = improved.anglesBefore;
        add("bad_tets_before_improvement", counts.badBefore);
        add("bad_tets_after_improvement", counts.badAfter);
        add("edge_removals", counts.edgeRemovals);
        add("face_removals", counts.faceRemovals);
        add("boundary_swaps", counts.boundarySwaps);
        add("contractions", counts.contractions);
        add("improvement_insertions", counts.insertions);
        add("inner_moves", counts.innerMoves);
        add("face_moves", counts.faceMoves);
        add("edge_moves", counts.edgeMoves);
    }

    bool mayGoOn(StopReason reason)
    {
        if (reason == StopReason::Done || reason == StopReason::CannotImprove) return true;
        tellStop(reason, report());
        return false;
    }

    [[nodiscard]] std::optional<Clock::duration> timeLeft() const
    {
        if (!options_.timeout) return std::nullopt;
        const double left = std::max(0.0, std::min(*options_.timeout, 1e9) - secondsSince(start_));
        return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(left));
    }

    void add(const char* name, std::uint64_t count) { report().counts.emplace_back(name, count); }
    void addSeconds(const char* stage, Clock::time_point start)
    {
        report().seconds.emplace_back(stage, secondsSince(start));
    }

    const BrepModel& model_;
    const MeshOptions& options_;
    RunContext& context_;
    Clock::time_point start_;
    RegionSides sides_;
    std::shared_ptr<const SizingField> sizes_;
    SurfaceSample sample_;
    bool isSampled_ = false;
    Tetrahedralization tetrahedralization_;
    MeshOutcome outcome_;
};

Result<void> checkSolids(const BrepModel& model)
{
    if (model.solids.empty()) {
        return Error{ErrorCode::InvalidArgument,
                     "has no solid",
                     "model",
                     {},
                     "close its shell, or mesh its faces with --dimension 2"};
    }
    for (std::uint32_t i = 0; i < model.solids.size(); ++i) {
        for (const BrepShell& shell : model.solids[BrepSolidId(i)].shells) {
            if (shell.isClosed) continue;
            const std::string face =
                shell.faces.empty() ? std::string("none") : nameOf(shell.faces.front().face);
            return Error{ErrorCode::InvalidArgument,
                         "has an open shell, that of " + face,
                         nameOf(BrepSolidId(i)),
                         {},
                         "close the shell, or mesh its faces with --dimension 2"};
        }
    }
    return {};
}

/// Volume and area of the model, where they are known well enough.
void tellMeasures(const BrepModel& model, MeshReport& report)
{
    const SolidVolume volume = volumeOf(model);
    if (volume.uncertainty > kReportedUncertainty * volume.value) return;
    report.modelVolume = volume.value;
    double area = 0.0;
    for (const BrepFace& face : model.faces) area += areaOf(model, face);
    report.modelArea = area;
}

Result<std::shared_ptr<const SizingField>> prepareSizes(const BrepModel& model, const MeshOptions& options,
                                                        std::shared_ptr<const SizingField> fromFiles)
{
    if (options.order != 1) return notYet("--order 2", "is not yet there for solids and faces in space");
    if (options.minAngle > kLargestMinAngle) {
        return Error{ErrorCode::InvalidArgument,
                     "cannot be above 34 degrees on faces in space",
                     "--min-angle",
                     {},
                     "give an angle from 0 to 34"};
    }
    return solidSizes(model, options, std::move(fromFiles));
}

void addTo(std::vector<std::pair<std::string, std::uint64_t>>& counts, const std::string& name,
           std::uint64_t count)
{
    const auto found =
        std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == name; });
    if (found == counts.end()) {
        counts.emplace_back(name, count);
    } else {
        found->second += count;
    }
}

void addTo(std::vector<std::pair<std::string, double>>& seconds, const std::string& name, double spent)
{
    const auto found =
        std::find_if(seconds.begin(), seconds.end(), [&](const auto& s) { return s.first == name; });
    if (found == seconds.end()) {
        seconds.emplace_back(name, spent);
    } else {
        found->second += spent;
    }
}

/// Adds what a component's run did to the report of the whole, with the names of the whole.
void addReport(const ModelComponent& component, const MeshReport& part, MeshReport& whole)
{
    for (const auto& [name, count] : part.counts) addTo(whole.counts, name, count);
    for (const auto& [name, spent] : part.seconds) addTo(whole.seconds, name, spent);
    if (const auto& angles = part.anglesBeforeImprovement) {
        if (!whole.anglesBeforeImprovement) whole.anglesBeforeImprovement = DihedralRange{};
        DihedralRange& all = *whole.anglesBeforeImprovement;
        all = {std::min(all.least, angles->least), std::max(all.largest, angles->largest)};
    }
    for (Error error : part.failures) {
        error.entity = component.inWhole(error.entity);
        error.message = component.inWhole(error.message);
        whole.failures.push_back(std::move(error));
    }
    for (LeftElements left : part.left) {
        left.reason = component.inWhole(left.reason);
        for (std::string& entity : left.entities) entity = component.inWhole(entity);
        whole.left.push_back(std::move(left));
    }
    for (const std::string& warning : part.warnings) whole.warnings.push_back(component.inWhole(warning));
    if (part.status == MeshReport::Status::Cancelled || whole.status == MeshReport::Status::Done)
        whole.status = part.status;
    if (whole.stopReason == StopReason::Done) whole.stopReason = part.stopReason;
}

void finish(const MeshOptions& options, MeshOutcome& outcome)
{
    std::stable_sort(outcome.report.left.begin(), outcome.report.left.end(),
                     [](const LeftElements& a, const LeftElements& b) { return a.count > b.count; });
    if (!outcome.mesh) return;
    describeMesh(*outcome.mesh, outcome.report);
    const bool isWhole = outcome.report.status == MeshReport::Status::Done;
    if (isWhole && options.isChecked) checkWhole(*outcome.mesh, outcome.report);
}

std::vector<SampledComponent> sampledComponents(const std::vector<ModelComponent>& components,
                                                const std::deque<SolidRun>& runs)
{
    std::vector<SampledComponent> sampled;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (runs[i].surface() != nullptr)
            sampled.push_back({&components[i], runs[i].surface(), &runs[i].sides()});
    }
    return sampled;
}

MeshOutcome refused(const MeshOptions& options, const Error& error)
{
    MeshOutcome outcome;
    outcome.report.options = options;
    fail(outcome.report, error);
    return outcome;
}

}  // namespace

MeshOutcome meshSolids(const BrepModel& model, const MeshOptions& options,
                       std::shared_ptr<const SizingField> fromFiles, RunContext& context)
{
    const Clock::time_point start = Clock::now();
    if (const Result<void> sound = checkSolids(model); !sound) return refused(options, sound.error());
    const auto sizes = prepareSizes(model, options, std::move(fromFiles));
    if (!sizes) return refused(options, sizes.error());
    MeshOutcome whole;
    whole.report.options = options;
    if (options.refinement != 1.0)
        whole.report.warnings.push_back("--refinement has no effect on solids yet");
    tellMeasures(model, whole.report);
    const Result<void> affordable = checkAffordable(estimateSolids(model, options, sizes->get()), options);
    if (!affordable) {
        fail(whole.report, affordable.error());
        return whole;
    }
    const std::vector<ModelComponent> components = solidComponents(model);
    std::deque<SolidRun> runs;
    for (const ModelComponent& component : components)
        runs.emplace_back(component.model, options, sizes.value(), context, start).sampleSurfaces();
    const bool areFree = tellContacts(sampledComponents(components, runs), whole.report);
    ClassifiedMesh mesh;
    for (std::size_t i = 0; i < components.size(); ++i) {
        whole.report.warnings.insert(whole.report.warnings.end(), components[i].notes.begin(),
                                     components[i].notes.end());
        const MeshOutcome part = areFree ? runs[i].meshVolumes() : runs[i].keepSurface();
        addReport(components[i], part.report, whole.report);
        if (part.mesh) appendComponent(components[i], *part.mesh, mesh);
        if (whole.report.status == MeshReport::Status::Cancelled) return whole;
    }
    if (!mesh.nodes.empty()) whole.mesh = std::move(mesh);
    finish(options, whole);
    return whole;
}

Result<MeshEstimate> estimateSolidModel(const BrepModel& model, const MeshOptions& options,
                                        std::shared_ptr<const SizingField> fromFiles)
{
    if (const Result<void> sound = checkSolids(model); !sound) return sound.error();
    const Result<std::shared_ptr<const SizingField>> sizes = solidSizes(model, options, std::move(fromFiles));
    if (!sizes) return sizes.error();
    return estimateSolids(model, options, sizes->get());
}

MeshOutcome meshFaces(const BrepModel& model, const MeshOptions& options,
                      std::shared_ptr<const SizingField> fromFiles, RunContext& context)
{
    const auto sizes = prepareSizes(model, options, std::move(fromFiles));
    if (!sizes) return refused(options, sizes.error());
    MeshOutcome outcome = SolidRun(model, options, sizes.value(), context, Clock::now()).meshFaces();
    finish(options, outcome);
    return outcome;
}

}  // namespace mesher
