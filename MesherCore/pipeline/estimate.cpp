#include "pipeline/estimate.h"

#include "pipeline/mesh_planar.h"
#include "pipeline/planar_sizes.h"
#include "triangulation2d/triangulate_planar.h"

#include <charconv>
#include <utility>

namespace mesher {

namespace {

constexpr double kBytesForTriangle = 260.0;  // triangulation, queues and the finished mesh
constexpr double kTrianglesInSecond = 1.0e6;
constexpr double kUncertainty = 2.0;

std::string rounded(double value)
{
    char digits[32];
    return {digits,
            std::to_chars(std::begin(digits), std::end(digits), value, std::chars_format::general, 3).ptr};
}

}  // namespace

MeshEstimate costOfTriangles(double triangles)
{
    return {triangles, kBytesForTriangle * triangles, triangles / kTrianglesInSecond};
}

Result<MeshEstimate> estimatePlanar(const PlanarCurveComplex& complex, const MeshOptions& options,
                                    std::shared_ptr<const SizingField> fromFiles, RunContext& context)
{
    if (const Result<void> valid = validate(options); !valid) return valid.error();
    const Result<PlanarSizes> sizes = planarSizes(complex, options, std::move(fromFiles));
    if (!sizes) return sizes.error();
    PlanarOptions planar = planarOptionsOf(options, sizes->field.get());
    planar.isRefined = false;
    const Result<PlanarResult> result = triangulatePlanar(complex, planar, context);
    if (!result) return result.error();
    return costOfTriangles(result->counts.expectedTriangles);
}

double mostExpectedElements(const MeshOptions& options)
{
    return kUncertainty * static_cast<double>(options.maxElements);
}

Result<void> checkAffordable(const MeshEstimate& estimate, const MeshOptions& options)
{
    if (estimate.elements <= mostExpectedElements(options)) return {};
    return Error{ErrorCode::OutOfRange,
                 "about " + rounded(estimate.elements) + " elements and " + rounded(estimate.bytes / 1e9) +
                     " GB of memory would be needed, more than --max-elements " +
                     std::to_string(options.maxElements),
                 estimate.entity.empty() ? "model" : estimate.entity,
                 {},
                 "choose larger sizes or raise --max-elements"};
}

}  // namespace mesher
