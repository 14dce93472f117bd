#include "pipeline/mesh_solids.h"

#include "brep/model_measures.h"
#include "brep/name_list.h"
#include "mesh/node_order.h"
#include "pipeline/component_contacts.h"
#include "pipeline/estimate_solids.h"
#include "pipeline/merge_reports.h"
#include "pipeline/model_components.h"
#include "pipeline/report_steps.h"
#include "pipeline/settled_nodes.h"
#include "pipeline/solid_run.h"
#include "pipeline/solid_sizes.h"
#include "pipeline/stage_watch.h"
#include "pipeline/wall_budget.h"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

constexpr double kReportedUncertainty = 1e-4;  // of the model's volume, relative
constexpr double kLargestMinAngle = 34.0;      // degrees, see FacetCriteriaOptions

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
        if (model.solids[BrepSolidId(i)].shells.empty()) {
            return Error{ErrorCode::DegenerateInput,
                         "the solid is empty, it has no face",
                         nameOf(BrepSolidId(i)),
                         {},
                         "delete it in the CAD program"};
        }
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

/// Faces beside solids and inside of them.
void tellLooseFaces(const BrepModel& model, MeshReport& report)
{
    std::vector<std::string> faces;
    for (const BrepShell& shell : model.looseShells) {
        for (const BrepShellFace& use : shell.faces) faces.push_back(nameOf(use.face));
    }
    if (faces.empty()) return;
    report.warnings.push_back(listOf(faces) + (faces.size() == 1 ? " bounds" : " bound") + " no solid and " +
                              (faces.size() == 1 ? "is" : "are") + " not meshed");
}

/// Volume and area of the model, where they are known well enough.
void tellMeasures(const ModelMeasures& measures, MeshReport& report)
{
    const SolidVolume& volume = measures.volume;
    if (volume.uncertainty > kReportedUncertainty * volume.value) return;
    report.modelVolume = volume.value;
    report.modelArea = measures.area();
}

Result<std::shared_ptr<const SizingField>> prepareSizes(const BrepModel& model, const MeshOptions& options,
                                                        std::shared_ptr<const SizingField> fromFiles,
                                                        RunContext& context)
{
    if (options.order != 1) {
        return Error{ErrorCode::InvalidArgument,
                     "elements of second order are not there yet for solids and faces in space",
                     "--order 2",
                     {},
                     "choose --order 1"};
    }
    if (options.minAngle > kLargestMinAngle) {
        return Error{ErrorCode::InvalidArgument,
                     "cannot be above 34 degrees on faces in space",
                     "--min-angle",
                     {},
                     "give an angle from 0 to 34"};
    }
    return solidSizes(model, options, std::move(fromFiles), context);
}

void finishMesh(const BrepModel& model, const MeshOptions& options, MeshOutcome& outcome, RunContext& context)
{
    const SettledNodes settled = settleNodes(*outcome.mesh, model);
    outcome.report.counts.emplace_back("settled_nodes", settled.settled);
    outcome.report.counts.emplace_back("unsettled_nodes", settled.kept);
    if (!context.mayGoOn()) return;
    sortNodesByEntity(*outcome.mesh);
    if (!context.mayGoOn()) return;
    describeMesh(*outcome.mesh, outcome.report);
    const bool isWhole = outcome.report.status == MeshReport::Status::Done;
    if (isWhole && options.isChecked && context.mayGoOn()) checkWhole(*outcome.mesh, outcome.report, context);
}

/// Orders, measures and checks the mesh. What there is although the time is over is finished without a limit.
void finish(const BrepModel& model, const MeshOptions& options, MeshOutcome& outcome, RunContext& context)
{
    std::stable_sort(outcome.report.left.begin(), outcome.report.left.end(),
                     [](const LeftElements& a, const LeftElements& b) { return a.count > b.count; });
    std::stable_sort(outcome.report.nonDelaunay.begin(), outcome.report.nonDelaunay.end(),
                     [](const LeftFaces& a, const LeftFaces& b) { return a.count > b.count; });
    if (!outcome.mesh) return;
    const StageWatch watch;
    {
        const TimeLimitPause pause(context, outcome.report.stopReason == StopReason::TimeLimit);
        finishMesh(model, options, outcome, context);
        const std::optional<StopReason> reason = context.stopReason();
        if (reason) tellStop(*reason, outcome.report);
        // A mesh that is not finished is none.
        if (reason) outcome.mesh.reset();
    }
    watch.addTo(outcome.report, "measures");
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
    context.limitTime(options.timeout);
    if (const Result<void> sound = checkSolids(model); !sound) return refused(options, sound.error());
    context.enterStage("sizes");
    const auto sizes = prepareSizes(model, options, std::move(fromFiles), context);
    if (!sizes) return refused(options, sizes.error());
    MeshOutcome whole;
    whole.report.options = options;
    tellLooseFaces(model, whole.report);
    context.enterStage("estimate");
    const StageWatch estimation;
    const ModelMeasures measures = measureModel(model, context);
    const MeshEstimate estimate = estimateSolids(model, measures, options, sizes->get(), context);
    estimation.addTo(whole.report, "estimate");
    if (const std::optional<StopReason> reason = context.stopReason()) {
        tellStop(*reason, whole.report);
        return whole;
    }
    tellMeasures(measures, whole.report);
    const Result<void> affordable = checkAffordable(estimate, options);
    if (!affordable) {
        fail(whole.report, affordable.error());
        return whole;
    }
    const std::vector<ModelComponent> components = solidComponents(model);
    std::deque<SolidRun> runs;
    const std::vector<WallBudget> budgets = wallBudgets(components, options, estimate);
    for (std::size_t i = 0; i < components.size(); ++i)
        runs.emplace_back(components[i].model, options, sizes.value(), budgets[i], context).sampleSurfaces();
    std::vector<SolidOverlap> overlaps;
    bool areFree = false;
    if (context.mayGoOn()) {
        context.enterStage("contacts");
        const StageWatch comparison;
        overlaps = tellContacts(sampledComponents(components, runs), whole.report, context);
        areFree = context.mayGoOn() && (overlaps.empty() || options.overlap == OverlapChoice::Separate);
        comparison.addTo(whole.report, "contacts");
    }
    ClassifiedMesh mesh;
    for (std::size_t i = 0; i < components.size(); ++i) {
        whole.report.warnings.insert(whole.report.warnings.end(), components[i].notes.begin(),
                                     components[i].notes.end());
        const MeshOutcome part = areFree ? runs[i].meshVolumes() : runs[i].keepSurface();
        addReport(components[i], part.report, whole.report);
        if (part.mesh) appendComponent(components[i], *part.mesh, mesh);
    }
    if (whole.report.status == MeshReport::Status::Cancelled) return whole;
    if (areFree) tellOverlaps(overlaps, mesh, model.unit, whole.report);
    if (!mesh.nodes.empty()) whole.mesh = std::move(mesh);
    finish(model, options, whole, context);
    return whole;
}

Result<MeshEstimate> estimateSolidModel(const BrepModel& model, const MeshOptions& options,
                                        std::shared_ptr<const SizingField> fromFiles, RunContext& context)
{
    if (const Result<void> sound = checkSolids(model); !sound) return sound.error();
    const auto sizes = solidSizes(model, options, std::move(fromFiles), context);
    if (!sizes) return sizes.error();
    return estimateSolidsBySample(model, options, *sizes, context);
}

MeshOutcome meshFaces(const BrepModel& model, const std::vector<BrepFaceId>& faces,
                      const MeshOptions& options, std::shared_ptr<const SizingField> fromFiles,
                      RunContext& context)
{
    context.limitTime(options.timeout);
    const auto sizes = prepareSizes(model, options, std::move(fromFiles), context);
    if (!sizes) return refused(options, sizes.error());
    MeshOutcome whole;
    if (faces.size() == model.faces.size()) {
        whole = SolidRun(model, options, sizes.value(), wallBudgetOfFaces(options), context).meshFaces();
    } else {
        const ModelComponent component = facesAlone(model, faces);
        const MeshOutcome part =
            SolidRun(component.model, options, sizes.value(), wallBudgetOfFaces(options), context)
                .meshFaces();
        whole.report.options = options;
        addReport(component, part.report, whole.report);
        if (part.mesh) appendComponent(component, *part.mesh, whole.mesh.emplace());
    }
    finish(model, options, whole, context);
    return whole;
}

}  // namespace mesher
