#include "pipeline/mesh_model.h"

#include "brep/edge_moving.h"
#include "brep/planarity.h"
#include "pipeline/mesh_planar.h"
#include "pipeline/mesh_solids.h"
#include "pipeline/model_extent.h"
#include "pipeline/planar_area.h"
#include "pipeline/planar_model.h"
#include "pipeline/stage_failure.h"
#include "predicates/fp_environment.h"

#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

MeshOutcome refuse(Error error)
{
    MeshOutcome outcome;
    outcome.report.status = MeshReport::Status::Failed;
    if (error.entity.empty()) error.entity = "model";
    outcome.report.failures.push_back(std::move(error));
    return outcome;
}

MeshOutcome meshPlaneFaces(const BrepModel& model, const MeshOptions& options,
                           std::shared_ptr<const SizingField> fromFiles, int boundaryOrder,
                           RunContext& context)
{
    const Result<PlanarCurveComplex> complex = planarModel(model, options);
    if (!complex) return refuse(complex.error());
    PlanarMeshOutcome planar =
        meshPlanar(complex.value(), options, std::move(fromFiles), boundaryOrder, context, &model);
    MeshOutcome outcome;
    outcome.report = std::move(planar.report);
    outcome.report.modelArea = planarArea(complex.value());
    if (planar.result) {
        outcome.mesh = std::move(planar.result->mesh);
        outcome.curvedBoundary = std::move(planar.result->boundary);
        outcome.curvedBoundary->unit = model.unit;
    }
    return outcome;
}

MeshOutcome meshByDimension(const BrepModel& model, const MeshOptions& options,
                            std::shared_ptr<const SizingField> fromFiles, int boundaryOrder,
                            RunContext& context)
{
    if (const Result<void> sound = checkFloatingPointEnvironment(); !sound) return refuse(sound.error());
    if (const Result<void> possible = validate(options); !possible) return refuse(possible.error());
    if (const Result<void> sound = checkExtent(model); !sound) return refuse(sound.error());
    if (options.dimension == 3) return meshSolids(model, options, std::move(fromFiles), context);
    const Result<std::vector<BrepFaceId>> faces = facesToMesh(model, options);
    if (!faces) return refuse(faces.error());
    if (lieInOnePlane(model, faces.value()))
        return meshPlaneFaces(model, options, std::move(fromFiles), boundaryOrder, context);
    return meshFaces(model, faces.value(), options, std::move(fromFiles), context);
}

MeshOutcome meshOrTellFailure(const BrepModel& model, const MeshOptions& options,
                              std::shared_ptr<const SizingField> fromFiles, int boundaryOrder,
                              RunContext& context)
{
    try {
        return meshByDimension(model, options, std::move(fromFiles), boundaryOrder, context);
    } catch (...) {
        return refuse(errorInFlight(context.stage()));
    }
}

/// The faces named in the failures, "Face29 and Face38".
std::vector<BrepFaceId> failedFaces(const MeshReport& report, const BrepModel& model)
{
    std::vector<BrepFaceId> faces;
    for (const Error& error : report.failures) {
        std::istringstream words(error.entity);
        for (std::string word; words >> word;) {
            const std::optional<EntityRef> entity = entityNamed(word);
            if (entity && entity->dimension == 2 && entity->index < model.faces.size())
                faces.push_back(BrepFaceId(entity->index));
        }
    }
    return faces;
}

/// Where faces fail whose edges lie off them, the run is repeated with these moved onto them.
MeshOutcome meshWithinTolerances(const BrepModel& model, const MeshOptions& options,
                                 const std::shared_ptr<const SizingField>& fromFiles, int boundaryOrder,
                                 RunContext& context)
{
    constexpr int kMostRepeats = 3;
    MeshOutcome outcome = meshOrTellFailure(model, options, fromFiles, boundaryOrder, context);
    if (outcome.report.failures.empty()) return outcome;
    BrepModel changed = model;
    std::vector<std::string> notes;
    for (int i = 0; i < kMostRepeats && outcome.report.stopReason == StopReason::Done; ++i) {
        const std::vector<std::string> moved =
            moveEdgesOntoFaces(changed, failedFaces(outcome.report, model));
        if (moved.empty()) break;
        notes.insert(notes.end(), moved.begin(), moved.end());
        outcome = meshOrTellFailure(changed, options, fromFiles, boundaryOrder, context);
    }
    outcome.report.warnings.insert(outcome.report.warnings.begin(), notes.begin(), notes.end());
    return outcome;
}

}  // namespace

MeshOutcome meshModel(const BrepModel& model, const MeshOptions& options,
                      std::shared_ptr<const SizingField> fromFiles, int boundaryOrder, RunContext& context)
{
    MeshOutcome outcome = meshWithinTolerances(model, options, fromFiles, boundaryOrder, context);
    MeshReport& report = outcome.report;
    report.options = options;
    report.versions = {{"mesher", MESHER_VERSION}};
    report.unit = model.unit;
    report.warnings.insert(report.warnings.begin(), model.notes.begin(), model.notes.end());
    if (const std::size_t missing = context.missingThreads(); missing > 0) {
        report.warnings.push_back(std::to_string(missing) + " of " + std::to_string(context.threads()) +
                                  " threads could not be made, so that the run took longer");
    }
    if (outcome.mesh) outcome.mesh->unit = model.unit;
    return outcome;
}

}  // namespace mesher
