#include "pipeline/mesh_model.h"

#include "pipeline/mesh_planar.h"
#include "pipeline/mesh_solids.h"
#include "pipeline/model_extent.h"
#include "pipeline/planar_area.h"
#include "pipeline/planar_model.h"
#include "predicates/fp_environment.h"

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

/// Whether the faces to mesh lie in parallel planes, so that the mesher of plane domains tells what is wrong if they cannot be
/// meshed together.
bool isPlane(const BrepModel& model, const MeshOptions& options)
{
    constexpr double kLargestTurn = 1e-6;  // radians; the exact test is that of planarCurveComplex
    if (!options.faces.empty()) return true;
    std::optional<PlaneFrame> first;
    for (const BrepFace& face : model.faces) {
        const std::optional<PlaneFrame> frame = face.surface->planeFrame();
        if (!frame) return false;
        if (!first) first = frame;
        if (length(cross(frame->normal, first->normal)) > kLargestTurn) return false;
    }
    return true;
}

MeshOutcome meshPlaneFaces(const BrepModel& model, const MeshOptions& options,
                           std::shared_ptr<const SizingField> fromFiles, int boundaryOrder,
                           RunContext& context)
{
    const Result<PlanarCurveComplex> complex = planarModel(model, options);
    if (!complex) return refuse(complex.error());
    PlanarMeshOutcome planar =
        meshPlanar(complex.value(), options, std::move(fromFiles), boundaryOrder, context);
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
    if (isPlane(model, options))
        return meshPlaneFaces(model, options, std::move(fromFiles), boundaryOrder, context);
    return meshFaces(model, options, std::move(fromFiles), context);
}

}  // namespace

MeshOutcome meshModel(const BrepModel& model, const MeshOptions& options,
                      std::shared_ptr<const SizingField> fromFiles, int boundaryOrder, RunContext& context)
{
    MeshOutcome outcome = meshByDimension(model, options, std::move(fromFiles), boundaryOrder, context);
    MeshReport& report = outcome.report;
    report.options = options;
    report.versions = {{"mesher", MESHER_VERSION}};
    report.unit = model.unit;
    report.warnings.insert(report.warnings.begin(), model.notes.begin(), model.notes.end());
    if (outcome.mesh) outcome.mesh->unit = model.unit;
    return outcome;
}

}  // namespace mesher
