#include "pipeline/estimate_model.h"

#include "pipeline/mesh_solids.h"
#include "pipeline/planar_model.h"
#include "pipeline/stage_failure.h"

#include <utility>

namespace mesher {

namespace {

Result<MeshEstimate> estimateByDimension(const BrepModel& model, const MeshOptions& options,
                                         std::shared_ptr<const SizingField> fromFiles, RunContext& context)
{
    context.limitTime(options.timeout);
    if (const Result<void> valid = validate(options); !valid) return valid.error();
    if (options.dimension == 3) return estimateSolidModel(model, options, std::move(fromFiles), context);
    const Result<PlanarCurveComplex> complex = planarModel(model, options);
    if (!complex) return complex.error();
    return estimatePlanar(complex.value(), options, std::move(fromFiles), context);
}

}  // namespace

Result<MeshEstimate> estimateModel(const BrepModel& model, const MeshOptions& options,
                                   std::shared_ptr<const SizingField> fromFiles, RunContext& context)
{
    try {
        return estimateByDimension(model, options, std::move(fromFiles), context);
    } catch (...) {
        return errorInFlight("estimate");
    }
}

}  // namespace mesher
