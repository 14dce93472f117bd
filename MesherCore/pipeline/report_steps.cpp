#include "pipeline/report_steps.h"

#include "mesh/mesh_check.h"

#include <string>
#include <utility>

namespace mesher {

namespace {

std::string limitMessage(StopReason reason, const MeshOptions& options)
{
    switch (reason) {
        case StopReason::ElementLimit:
            return "the limit of " + std::to_string(options.maxElements) + " elements is reached";
        case StopReason::TimeLimit: return "the time limit is reached";
        case StopReason::Cancelled: return "the run was cancelled";
        case StopReason::CannotImprove: return "the mesh cannot be improved any further";
        default: return "a limit of the run is reached";
    }
}

}  // namespace

void fail(MeshReport& report, Error error)
{
    report.status = MeshReport::Status::Failed;
    if (error.entity.empty()) error.entity = "model";
    report.failures.push_back(std::move(error));
}

Error errorOf(StopReason reason, const MeshOptions& options)
{
    const bool isElements = reason == StopReason::ElementLimit;
    std::string remedy;
    if (reason != StopReason::Cancelled)
        remedy = isElements ? "choose a larger --size or raise --max-elements"
                            : "choose a larger --size or raise --timeout";
    return {ErrorCode::OutOfRange, limitMessage(reason, options), "model", {}, std::move(remedy)};
}

void tellStop(StopReason reason, MeshReport& report)
{
    report.stopReason = reason;
    if (reason == StopReason::Done) return;
    report.status =
        reason == StopReason::Cancelled ? MeshReport::Status::Cancelled : MeshReport::Status::Failed;
    report.failures.push_back(errorOf(reason, report.options));
}

void checkWhole(const ClassifiedMesh& mesh, MeshReport& report, RunContext& context)
{
    const MeshCheckReport check = checkMesh(mesh, context);
    if (!context.mayGoOn()) return;
    for (const std::string& problem : check.problems()) {
        fail(report, {ErrorCode::InvalidArgument,
                      "the check of the mesh found " + problem,
                      "mesh",
                      {},
                      "report this model as a fault of the mesher"});
    }
}

}  // namespace mesher
