#include "brep/occt/read_model.h"
#include "cli/commands.h"
#include "cli/size_files.h"
#include "pipeline/estimate.h"
#include "pipeline/planar_model.h"

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
    const Result<std::shared_ptr<const SizingField>> sizes = readSizeFiles(command.options);
    if (!sizes) return tell(sizes.error(), ExitStatus::Failed, console);
    const Result<ReadModel> read = readModel(command.model, ReadOptions{command.heals});
    if (!read) return tell(read.error(), ExitStatus::Failed, console);
    const Result<PlanarCurveComplex> complex = planarModel(read.value().model, command.options);
    if (!complex) return tell(inModel(complex.error(), command.model), ExitStatus::Failed, console);
    RunContext context;
    const Result<MeshEstimate> found =
        estimatePlanar(complex.value(), command.options, sizes.value(), context);
    if (!found) return tell(inModel(found.error(), command.model), ExitStatus::Failed, console);
    const MeshEstimate& estimate = found.value();
    console.out << std::setprecision(3) << "elements: about " << estimate.elements << "\nmemory: about "
                << estimate.bytes / 1e6 << " MB\ntime: about " << estimate.seconds << " s\n";
    const Result<void> affordable = checkAffordable(estimate, command.options);
    return affordable ? ExitStatus::Done
                      : tell(inModel(affordable.error(), command.model), ExitStatus::Failed, console);
}

}  // namespace mesher
