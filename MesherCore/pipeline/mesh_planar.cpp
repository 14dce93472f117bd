#include "pipeline/mesh_planar.h"

#include "mesh/node_order.h"
#include "pipeline/estimate.h"
#include "pipeline/left_triangles.h"
#include "pipeline/option_checks.h"
#include "pipeline/planar_sizes.h"
#include "pipeline/report_steps.h"
#include "pipeline/settled_nodes.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <utility>

namespace mesher {

namespace {

/// What plane meshes do not do yet is refused, not passed over.
Result<void> checkSupported(const MeshOptions& options)
{
    if (options.order != 1) {
        return Error{ErrorCode::InvalidArgument,
                     "elements of second order are not there yet for plane meshes",
                     "--order 2",
                     {},
                     "choose --order 1"};
    }
    return {};
}

/// What is beyond the integers is told as the largest power of ten among them.
std::uint64_t wholeNumber(double value)
{
    constexpr double kLargest = 1e19;
    return static_cast<std::uint64_t>(std::min(value, kLargest));
}

void tellCounts(const PlanarResult& result, MeshReport& report)
{
    const PlanarCounts& counts = result.counts;
    const Refinement2d& refinement = result.refinement;
    report.counts = {
        {"sample_vertices", counts.sampleVertices},
        {"small_angle_splits", counts.smallAngleSplits},
        {"enrichment_splits", counts.enrichment.splits},
        {"intersection_splits", counts.enrichment.intersectionSplits},
        {"initial_vertices", counts.initialVertices},
        {"initial_triangles", counts.initialTriangles},
        {"expected_triangles", wholeNumber(counts.expectedTriangles)},
        {"size_insertions", refinement.sizeInsertions},
        {"quality_insertions", refinement.qualityInsertions},
        {"boundary_splits", refinement.sizeSplits + refinement.encroachmentSplits},
        {"boundary_edges", counts.boundaryEdges},
        {"triangles_left", refinement.left.size()},
    };
    report.seconds = {{"sampling", result.seconds.sampling},
                      {"enrichment", result.seconds.enrichment},
                      {"initial_triangulation", result.seconds.initialTriangulation},
                      {"refinement", result.seconds.refinement}};
}

/// Where features of the model rather than sizes that were asked for make a mesh large, the error names the smallest of them.
void nameSmallestFeature(const PlanarCurveComplex& complex, const PlanarTriangulation& triangulation,
                         const MeshOptions& options, Error& error)
{
    const Triangulation2d& mesh = triangulation.mesh();
    double smallest = 0.5 * options.size.value_or(std::numeric_limits<double>::infinity());
    for (const BoundaryVertex& vertex : triangulation.boundary.vertices) {
        if (!vertex.vertex.isValid() || !mesh.isAlive(vertex.vertex)) continue;
        const double scale = mesh.lengthScale(vertex.vertex) / triangulation.scale;
        if (!(scale < smallest)) continue;
        smallest = scale;
        error.entity = vertex.point.isValid() ? nameOf(complex.points[vertex.point.value].vertex)
                                              : nameOf(complex.curves[vertex.curve.value].edge);
        error.point = vertex.space;
    }
    if (error.point) error.message += ", since sizes go down to " + decimalOf(smallest) + " here";
}

/// A run that was expected to go beyond the limit on elements is told by how much.
void tellStop(const PlanarCurveComplex& complex, const PlanarResult& result, MeshReport& report)
{
    const Result<void> affordable =
        checkAffordable(costOfTriangles(result.counts.expectedTriangles), report.options);
    if (result.stopReason != StopReason::ElementLimit || affordable) {
        tellStop(result.stopReason, report);
        return;
    }
    report.stopReason = result.stopReason;
    Error error = affordable.error();
    nameSmallestFeature(complex, result.triangulation, report.options, error);
    fail(report, std::move(error));
}

/// Nodes without the noise of their evaluation, in the order of their entities.
void settle(PlanarMesh& planar, const BrepModel* model, MeshReport& report)
{
    if (model != nullptr)
        report.counts.emplace_back("settled_nodes", settleNodes(planar.mesh, *model).settled);
    const IdVector<NodeId, NodeId> moved = sortNodesByEntity(planar.mesh);
    for (CurvedBoundaryEdge& edge : planar.boundary.edges) {
        for (NodeId& node : edge.node) node = moved[node];
    }
}

}  // namespace

PlanarOptions planarOptionsOf(const MeshOptions& options, const SizingField* field)
{
    PlanarOptions planar;
    planar.sampling.maxVariation = options.maxTurn;
    planar.refinement.minAngle = options.minAngle;
    planar.refinement.sizing.refinement = options.refinement.value_or(1.0);
    planar.refinement.sizing.grading = options.grading;
    planar.refinement.sizing.field = field;
    planar.limits.maxElements = options.maxElements;
    planar.mostExpectedTriangles = mostExpectedElements(options);
    return planar;
}

PlanarMeshOutcome meshPlanar(const PlanarCurveComplex& complex, const MeshOptions& options,
                             std::shared_ptr<const SizingField> fromFiles, int boundaryOrder,
                             RunContext& context, const BrepModel* model)
{
    context.limitTime(options.timeout);
    PlanarMeshOutcome outcome;
    MeshReport& report = outcome.report;
    report.options = options;
    report.versions = {{"mesher", MESHER_VERSION}};
    Result<void> possible = validate(options);
    if (possible) possible = checkSupported(options);
    if (!possible) {
        fail(report, possible.error());
        return outcome;
    }
    const Result<PlanarSizes> sizes = planarSizes(complex, options, std::move(fromFiles));
    if (!sizes) {
        fail(report, sizes.error());
        return outcome;
    }
    report.warnings = sizes->warnings;
    const PlanarOptions planar = planarOptionsOf(options, sizes->field.get());
    const Result<PlanarResult> result = triangulatePlanar(complex, planar, context);
    if (!result) {
        fail(report, result.error());
        return outcome;
    }
    tellCounts(result.value(), report);
    tellLeftTriangles(complex, result.value(), report);
    tellStop(complex, result.value(), report);
    // A run that ends early may not have got as far as a triangulation of the boundary.
    if (report.status == MeshReport::Status::Cancelled || result.value().counts.triangles == 0)
        return outcome;
    outcome.result = classifyPlanar(complex, result.value().triangulation, boundaryOrder);
    settle(*outcome.result, model, report);
    describeMesh(outcome.result->mesh, report);
    if (options.isChecked) checkWhole(outcome.result->mesh, report, context);
    return outcome;
}

}  // namespace mesher
