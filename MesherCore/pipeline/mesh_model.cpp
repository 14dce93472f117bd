#include "pipeline/mesh_model.h"

#include "brep/planar_domain.h"
#include "pipeline/estimate.h"
#include "pipeline/mesh_planar.h"
#include "pipeline/planar_area.h"

#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

MeshOutcome refuse(const MeshOptions& options, Error error)
{
    MeshOutcome outcome;
    outcome.report.options = options;
    outcome.report.versions = {{"mesher", MESHER_VERSION}};
    outcome.report.status = MeshReport::Status::Failed;
    if (error.entity.empty()) error.entity = "model";
    outcome.report.failures.push_back(std::move(error));
    return outcome;
}

/// All faces of the model, if none of them is turned against the first.
Result<std::vector<BrepFaceId>> facesInOnePlane(const BrepModel& model)
{
    constexpr double kLargestTurn = 1e-6;  // radians; the exact test is that of planarCurveComplex
    std::vector<BrepFaceId> faces;
    std::optional<PlaneFrame> first;
    for (std::uint32_t i = 0; i < model.faces.size(); ++i) {
        const std::optional<PlaneFrame> frame = model.faces[BrepFaceId(i)].surface->planeFrame();
        if (!first) first = frame;
        if (frame && length(cross(frame->normal, first->normal)) > kLargestTurn) {
            return Error{ErrorCode::InvalidArgument, "lies in another plane than the faces before it",
                         nameOf(BrepFaceId(i)), frame->origin, "mesh the faces of each plane on their own"};
        }
        faces.push_back(BrepFaceId(i));
    }
    return faces;
}

double areaOfPlaneFaces(const BrepModel& model)
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < model.faces.size(); ++i)
        area += planarArea(model, BrepFaceId(i)).value_or(0.0);
    return area;
}

MeshOutcome meshPlaneFaces(const BrepModel& model, const MeshOptions& options,
                           std::shared_ptr<const SizingField> background, int boundaryOrder,
                           RunContext& context)
{
    const Result<void> affordable = checkAffordable(estimatePlanar(model, options), options);
    if (!affordable) return refuse(options, affordable.error());
    const Result<std::vector<BrepFaceId>> faces = facesInOnePlane(model);
    if (!faces) return refuse(options, faces.error());
    const Result<PlanarCurveComplex> complex = planarCurveComplex(model, faces.value());
    if (!complex) return refuse(options, complex.error());
    PlanarMeshOutcome planar =
        meshPlanar(complex.value(), options, std::move(background), boundaryOrder, context);
    MeshOutcome outcome;
    outcome.report = std::move(planar.report);
    outcome.report.modelArea = areaOfPlaneFaces(model);
    if (planar.result) {
        outcome.mesh = std::move(planar.result->mesh);
        outcome.curvedBoundary = std::move(planar.result->boundary);
        outcome.mesh->unit = model.unit;
        outcome.curvedBoundary->unit = model.unit;
    }
    return outcome;
}

}  // namespace

MeshOutcome meshModel(const BrepModel& model, const MeshOptions& options,
                      std::shared_ptr<const SizingField> background, int boundaryOrder, RunContext& context)
{
    const Result<void> possible = validate(options);
    if (!possible) return refuse(options, possible.error());
    if (options.dimension == 3) {
        return refuse(options, {ErrorCode::InvalidArgument,
                                "solids are not yet meshed",
                                "model",
                                {},
                                "mesh plane faces with --dimension 2"});
    }
    MeshOutcome outcome = meshPlaneFaces(model, options, std::move(background), boundaryOrder, context);
    outcome.report.unit = model.unit;
    outcome.report.warnings.insert(outcome.report.warnings.begin(), model.notes.begin(), model.notes.end());
    return outcome;
}

}  // namespace mesher
