#include "pipeline/estimate_model.h"

#include "pipeline/mesh_solids.h"
#include "pipeline/planar_model.h"
#include "pipeline/stage_failure.h"

#include <utility>

namespace mesher {

namespace {

Result<MeshEstimate> estimateByDimension(const BrepModel& model, const MeshOptions& options,
                                         std::shared_ptr<const SizingField> fromFiles)
{
    if (const Result<void> valid = validate(options); !valid) return valid.error();
    if (options.dimension == 3) return estimateSolidModel(model, options, std::move(fromFiles));
    const Result<PlanarCurveComplex> complex = planarModel(model, options);
    if (!complex) return complex.error();
    RunContext context;
    return estimatePlanar(complex.value(), options, std::move(fromFiles), context);
}

}  // namespace

Result<MeshEstimate> estimateModel(const BrepModel& model, const MeshOptions& options,
                                   std::shared_ptr<const SizingField> fromFiles)
{
    try {
        return estimateByDimension(model, options, std::move(fromFiles));
    } catch (...) {
        return errorInFlight("estimate");
    }
}

}  // namespace mesher
