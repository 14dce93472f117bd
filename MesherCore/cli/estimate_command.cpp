#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/model_file.h"
#include "cli/supervisor.h"
#include "io/read_size_fields.h"
#include "pipeline/estimate_model.h"
#include "pipeline/report_steps.h"

#include <iomanip>

namespace mesher {

ExitStatus runEstimate(const MeshCommand& command, Console console)
{
    const MeshOptions& options = command.options;
    noteTimeLimit(options.timeout);
    RunContext context;
    context.limitTime(options.timeout);
    InterruptScope interrupt(context);
    const Result<std::shared_ptr<const SizingField>> sizes =
        readSizeFields(options.background, options.sizePoints, options.grading);
    if (!sizes) return tell(sizes.error(), ExitStatus::Failed, console);
    const Result<ReadModel> read = readModelFile(command.model, command.heals, "estimate");
    if (!read) return tell(read.error(), ExitStatus::Failed, console);
    interrupt.enter(InterruptScope::Phase::Cooperative);
    const Result<MeshEstimate> found = estimateModel(read.value().model, options, sizes.value(), context);
    if (const std::optional<StopReason> reason = context.stopReason()) {
        const bool isCancelled = *reason == StopReason::Cancelled;
        return tell(inModel(errorOf(*reason, options), command.model),
                    isCancelled ? ExitStatus::Cancelled : ExitStatus::Failed, console);
    }
    if (!found) return tell(inModel(found.error(), command.model), ExitStatus::Failed, console);
    const MeshEstimate& estimate = found.value();
    const char* const about = estimate.isLeast ? "at least " : "about ";
    console.out << std::setprecision(3) << "elements: " << about << estimate.elements << "\nmemory: " << about
                << estimate.bytes / 1e6 << " MB\ntime: " << about << estimate.seconds << " s\n";
    const Result<void> affordable = checkAffordable(estimate, options);
    return affordable ? ExitStatus::Done
                      : tell(inModel(affordable.error(), command.model), ExitStatus::Failed, console);
}

}  // namespace mesher
