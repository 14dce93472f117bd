#include "brep/occt/read_model.h"
#include "cli/commands.h"
#include "pipeline/estimate.h"

#include <iomanip>

namespace mesher {

ExitStatus runEstimate(const MeshCommand& command, Console console)
{
    if (command.options.dimension == 3) {
        const Error error = {ErrorCode::InvalidArgument,
                             "solids are not yet estimated",
                             command.model.string(),
                             {},
                             "estimate plane faces with --dimension 2"};
        return tell(error, ExitStatus::Failed, console);
    }
    const Result<ReadModel> read = readModel(command.model, ReadOptions{command.heals});
    if (!read) return tell(read.error(), ExitStatus::Failed, console);
    const MeshEstimate estimate = estimatePlanar(read.value().model, command.options);
    console.out << std::setprecision(3) << "elements: about " << estimate.elements << "\nmemory: about "
                << estimate.bytes / 1e6 << " MB\ntime: about " << estimate.seconds << " s\n";
    const Result<void> affordable = checkAffordable(estimate, command.options);
    return affordable ? ExitStatus::Done : tell(affordable.error(), ExitStatus::Failed, console);
}

}  // namespace mesher
