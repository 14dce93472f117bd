#include "brep/occt/read_model.h"
#include "cli/commands.h"
#include "cli/size_files.h"
#include "pipeline/estimate.h"
#include "pipeline/mesh_solids.h"
#include "pipeline/planar_model.h"

#include <iomanip>

namespace mesher {

namespace {

Result<MeshEstimate> estimateOf(const BrepModel& model, const MeshOptions& options,
                                const std::shared_ptr<const SizingField>& fromFiles)
{
    if (options.dimension == 3) return estimateSolidModel(model, options, fromFiles);
    const Result<PlanarCurveComplex> complex = planarModel(model, options);
    if (!complex) return complex.error();
    RunContext context;
    return estimatePlanar(complex.value(), options, fromFiles, context);
}

}  // namespace

ExitStatus runEstimate(const MeshCommand& command, Console console)
{
    const Result<std::shared_ptr<const SizingField>> sizes = readSizeFiles(command.options);
    if (!sizes) return tell(sizes.error(), ExitStatus::Failed, console);
    const Result<ReadModel> read = readModel(command.model, ReadOptions{command.heals});
    if (!read) return tell(read.error(), ExitStatus::Failed, console);
    const Result<MeshEstimate> found = estimateOf(read.value().model, command.options, sizes.value());
    if (!found) return tell(inModel(found.error(), command.model), ExitStatus::Failed, console);
    const MeshEstimate& estimate = found.value();
    console.out << std::setprecision(3) << "elements: about " << estimate.elements << "\nmemory: about "
                << estimate.bytes / 1e6 << " MB\ntime: about " << estimate.seconds << " s\n";
    const Result<void> affordable = checkAffordable(estimate, command.options);
    return affordable ? ExitStatus::Done
                      : tell(inModel(affordable.error(), command.model), ExitStatus::Failed, console);
}

}  // namespace mesher
