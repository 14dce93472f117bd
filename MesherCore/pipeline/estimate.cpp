#include "pipeline/estimate.h"

#include "pipeline/planar_area.h"

#include <algorithm>
#include <charconv>
#include <numbers>

namespace mesher {

namespace {

// An equilateral triangle of side h covers 0.433 h^2; Delaunay refinement uses triangles that are smaller on average.
constexpr double kTriangleArea = std::numbers::sqrt3 / 4.0;
constexpr double kRefinementSurplus = 1.2;
constexpr double kTrianglesForBoundaryEdge = 6.0;
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

MeshEstimate estimatePlanar(const BrepModel& model, const MeshOptions& options)
{
    double area = 0.0;
    double boundaryEdges = 0.0;
    for (std::uint32_t i = 0; i < model.faces.size(); ++i) {
        const BrepFaceId face(i);
        area += planarArea(model, face).value_or(0.0);
        for (const BrepLoop& loop : model.faces[face].loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                const double length = edgeLength(model.edges[coedge.edge]);
                boundaryEdges += std::max(4.0, options.size ? length / *options.size : 0.0);
            }
        }
    }
    MeshEstimate estimate;
    estimate.elements = kTrianglesForBoundaryEdge * boundaryEdges;
    if (options.size) {
        const double bulk = kRefinementSurplus * area / (kTriangleArea * *options.size * *options.size);
        estimate.elements = std::max(estimate.elements, bulk);
    }
    estimate.bytes = kBytesForTriangle * estimate.elements;
    estimate.seconds = estimate.elements / kTrianglesInSecond;
    return estimate;
}

Result<void> checkAffordable(const MeshEstimate& estimate, const MeshOptions& options)
{
    if (estimate.elements <= kUncertainty * static_cast<double>(options.maxElements)) return {};
    return Error{ErrorCode::OutOfRange,
                 "about " + rounded(estimate.elements) + " elements and " + rounded(estimate.bytes / 1e9) +
                     " GB of memory would be needed, more than --max-elements " +
                     std::to_string(options.maxElements),
                 "model",
                 {},
                 "choose a larger --size or raise --max-elements"};
}

}  // namespace mesher
