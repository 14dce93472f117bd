#include "pipeline/mesh_planar.h"

#include "mesh/mesh_check.h"
#include "support/planar_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace mesher {
namespace {

/// An annulus of radii 1 and 2 with names as a model would have them.
PlanarCurveComplex annulus()
{
    test::PlanarBuilder builder;
    builder.circle({0.0, 0.0}, 2.0, {1, 0});
    builder.circle({0.0, 0.0}, 1.0, {0, 1});
    PlanarCurveComplex complex = builder.build();
    for (std::uint32_t i = 0; i < complex.curves.size(); ++i) complex.curves[i].edge = BrepEdgeId(i);
    for (std::uint32_t i = 0; i < complex.points.size(); ++i) complex.points[i].vertex = BrepVertexId(i);
    complex.regionNames = {"Face1"};
    return complex;
}

MeshOptions sized(double size)
{
    MeshOptions options;
    options.dimension = 2;
    options.size = size;
    return options;
}

TEST(MeshPlanar, MakesAValidClassifiedMesh)
{
    RunContext context;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), sized(0.2), nullptr, 4, context);
    ASSERT_TRUE(outcome.result);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Done);
    for (const MeshNode& node : outcome.result->mesh.nodes) {
        EXPECT_TRUE(node.entity.dimension < 2 || node.entity.index == 0);
        if (node.entity.dimension != 1) continue;
        const PlanarCurveComplex complex = annulus();
        EXPECT_EQ(complex.curves[node.entity.index].curve->position(node.parameters.x), node.position);
    }
    const ClassifiedMesh& mesh = outcome.result->mesh;
    const MeshCheckReport check = checkMesh(mesh);
    EXPECT_TRUE(check.isValid());
    EXPECT_EQ(mesh.points.size(), 2u);
    for (const MeshElement<2>& line : mesh.lines) {
        const double radius = line.entity.index == 0 ? 2.0 : 1.0;
        for (const NodeId node : line.node) EXPECT_NEAR(length(mesh.nodes[node].position), radius, 1e-14);
    }
    EXPECT_GE(outcome.report.triangleQuality->angle.least(), 30.0);
    EXPECT_NEAR(check.area, 3.0 * std::numbers::pi, 0.02 * check.area);
}

/// Divergence theorem on the exact curves: the area is half the integral of x . n.
TEST(MeshPlanar, GivesGaussPointsThatEncloseTheExactArea)
{
    RunContext context;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), sized(0.2), nullptr, 4, context);
    ASSERT_TRUE(outcome.result);
    double area = 0.0;
    for (const CurvedBoundaryEdge& edge : outcome.result->boundary.edges) {
        const double outward = edge.left == EntityRef{2, 0} ? 1.0 : -1.0;
        for (const CurvedBoundaryPoint& p : edge.points)
            area += 0.5 * outward * p.weight * dot(p.position, p.normal);
    }
    EXPECT_NEAR(area, 3.0 * std::numbers::pi, 1e-12);
}

TEST(MeshPlanar, GivesTheSameMeshEachTime)
{
    RunContext first;
    RunContext second;
    const PlanarMeshOutcome a = meshPlanar(annulus(), sized(0.1), nullptr, 4, first);
    const PlanarMeshOutcome b = meshPlanar(annulus(), sized(0.1), nullptr, 4, second);
    EXPECT_EQ(a.report.meshHash, b.report.meshHash);
    EXPECT_NE(a.report.meshHash, 0u);
}

TEST(MeshPlanar, SaysThatALimitEndedIt)
{
    RunContext context;
    MeshOptions options = sized(0.02);
    options.maxElements = 40000;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Failed);
    EXPECT_EQ(outcome.report.stopReason, StopReason::ElementLimit);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_NE(describe(outcome.report.failures[0]).find("limit of 40000 elements"), std::string::npos);
    ASSERT_TRUE(outcome.result);
    EXPECT_GE(outcome.result->mesh.triangles.size(), 40000u);
    EXPECT_TRUE(checkMesh(outcome.result->mesh).isValid());
}

TEST(MeshPlanar, RefusesBeforehandWhatWouldExceedTheLimitByFar)
{
    RunContext context;
    MeshOptions options = sized(1e-200);
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    EXPECT_EQ(outcome.report.stopReason, StopReason::ElementLimit);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_NE(describe(outcome.report.failures[0]).find("would be needed"), std::string::npos);
    ASSERT_TRUE(outcome.result);
    EXPECT_LT(outcome.result->mesh.triangles.size(), 1000u);
}

TEST(MeshPlanar, NamesTheFeatureThatMakesAMeshTooLarge)
{
    RunContext context;
    MeshOptions options = sized(0.5);
    options.localSizes = {{"Edge2", 1e-6}};
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    const Error& error = outcome.report.failures[0];
    EXPECT_TRUE(error.entity == "Edge2" || error.entity == "Vertex2") << error.entity;
    ASSERT_TRUE(error.point);
    EXPECT_NEAR(length(*error.point), 1.0, 1e-12);
    EXPECT_NE(error.message.find("sizes go down to 1e-06 here"), std::string::npos) << error.message;
}

TEST(MeshPlanar, SaysThatItWasCancelled)
{
    RunContext context;
    context.requestCancel();
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), sized(0.1), nullptr, 4, context);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Cancelled);
    EXPECT_FALSE(outcome.result);
}

TEST(MeshPlanar, SurvivesALimitAtAnyPlace)
{
    for (std::uint64_t limit = 1; limit < 100; limit += 7) {
        RunContext context;
        MeshOptions options = sized(0.1);
        options.maxElements = limit;
        EXPECT_EQ(meshPlanar(annulus(), options, nullptr, 4, context).report.status,
                  MeshReport::Status::Failed);
    }
    RunContext context;
    MeshOptions options = sized(0.1);
    options.timeout = 1e-9;
    EXPECT_EQ(meshPlanar(annulus(), options, nullptr, 4, context).report.stopReason, StopReason::TimeLimit);
}

TEST(MeshPlanar, RefusesWhatIsNotThereYet)
{
    RunContext context;
    MeshOptions options = sized(0.1);
    options.order = 2;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Failed);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_EQ(outcome.report.failures[0].entity, "--order 2");
    EXPECT_FALSE(outcome.result);
}

double shortestEdgeWith(const MeshOptions& options)
{
    RunContext context;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    EXPECT_TRUE(outcome.result);
    return outcome.result ? outcome.report.triangleQuality->shortestEdge : 0.0;
}

/// Chords of the inner circle, of curvature 1, are shorter than those that the shape alone asks for.
/// A thin triangle with an angle of 10 degrees between its first and last edge.
PlanarCurveComplex needle()
{
    test::PlanarBuilder builder;
    const std::vector<Vec2> corners = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 0.7053}};
    builder.polygon(corners, {1, 0});
    PlanarCurveComplex complex = builder.build();
    for (std::uint32_t i = 0; i < complex.curves.size(); ++i) complex.curves[i].edge = BrepEdgeId(i);
    complex.regionNames = {"Face7"};
    return complex;
}

TEST(MeshPlanar, TellsTrianglesBesideSmallAnglesInReportAndWarning)
{
    RunContext context;
    const MeshReport report = meshPlanar(needle(), sized(0.3), nullptr, 4, context).report;
    ASSERT_EQ(report.left.size(), 1u);
    const LeftElements& left = report.left.front();
    EXPECT_EQ(left.dimension, 2);
    EXPECT_EQ(left.entities, (std::vector<std::string>{"Edge1", "Edge3"}));
    EXPECT_NEAR(left.leastAngle, report.triangleQuality->angle.least(), 1e-9);
    EXPECT_LT(left.leastAngle, 11.0);
    EXPECT_NE(left.reason.find("small angle"), std::string::npos);
    ASSERT_EQ(report.warnings.size(), 1u);
    EXPECT_NE(report.warnings.front().find("Edge1, Edge3 have angles below the 30 degrees"),
              std::string::npos)
        << report.warnings.front();
    EXPECT_TRUE(meshPlanar(annulus(), sized(0.3), nullptr, 4, context).report.warnings.empty());
}

TEST(MeshPlanar, GivesUpAnAngleThatIsOutOfReach)
{
    MeshOptions options = sized(0.1);
    options.minAngle = 38.0;
    RunContext context;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Done);
    ASSERT_TRUE(outcome.result);
    EXPECT_LT(outcome.result->mesh.triangles.size(), 20'000u);
    EXPECT_GE(outcome.report.triangleQuality->angle.least(), 30.0);
    ASSERT_EQ(outcome.report.warnings.size(), 1u);
    EXPECT_NE(outcome.report.warnings.front().find("out of reach"), std::string::npos);
}

TEST(MeshPlanar, KeepsSizesOfCurvesAndPoints)
{
    MeshOptions options = sized(0.5);
    EXPECT_GT(shortestEdgeWith(options), 0.15);
    options.curvature = 100.0;
    EXPECT_LT(shortestEdgeWith(options), 2.0 * std::numbers::pi / 100.0);
    options = sized(0.5);
    options.sag = 1e-4;
    EXPECT_LT(shortestEdgeWith(options), std::sqrt(8e-4));
    options = sized(0.5);
    options.localSizes = {{"Edge2", 0.05}};
    EXPECT_LT(shortestEdgeWith(options), 0.05);
    options.minSize = 0.4;
    EXPECT_GT(shortestEdgeWith(options), 0.15);
    options = sized(0.5);
    options.localSizes = {{"Vertex1", 0.02}};
    EXPECT_LT(shortestEdgeWith(options), 0.03);
}

/// What the field promises at a node and, by the limits of the refinement, what the edges there keep.
void expectEdgesWithin(const ClassifiedMesh& mesh, const std::function<double(Vec3)>& wanted)
{
    constexpr double kSlack = 1.8;  // triangles are refined by their circumradius, and may reach out of a box
    for (const MeshElement<3>& triangle : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = mesh.nodes[triangle.node[i]].position;
            const Vec3 b = mesh.nodes[triangle.node[(i + 1) % 3]].position;
            EXPECT_LE(length(b - a), kSlack * wanted(0.5 * (a + b)));
        }
    }
}

std::size_t expectSizes(const MeshOptions& options, const std::function<double(Vec3)>& wanted)
{
    RunContext context;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    EXPECT_TRUE(outcome.result);
    if (!outcome.result) return 0;
    EXPECT_TRUE(checkMesh(outcome.result->mesh).isValid());
    expectEdgesWithin(outcome.result->mesh, wanted);
    const auto triangles = static_cast<double>(outcome.result->mesh.triangles.size());
    for (const auto& [name, count] : outcome.report.counts) {
        if (name == "expected_triangles") {
            EXPECT_NEAR(static_cast<double>(count), triangles, 0.5 * triangles);
        }
    }
    return outcome.result->mesh.triangles.size();
}

TEST(MeshPlanar, KeepsSizesInBoxesAndBalls)
{
    const std::size_t plain = expectSizes(sized(0.4), [](Vec3) { return 0.4; });
    MeshOptions options = sized(0.4);
    options.boxSizes = {{{2.0, 0.5, 0.0}, {1.0, -0.5, 0.0}, 0.04, {}}};
    const std::size_t boxed = expectSizes(options, [](Vec3 p) {
        const bool isInside = p.x >= 1.0 && std::abs(p.y) <= 0.5;
        return isInside ? 0.04 : 0.4;
    });
    EXPECT_GT(boxed, 10 * plain / 4);
    options = sized(0.4);
    options.ballSizes = {{{0.0, 1.5, 0.0}, 0.3, 0.03, 0.1}};
    const std::size_t slow = expectSizes(options, [](Vec3 p) {
        return std::min(0.4, 0.03 + 0.1 * std::max(0.0, length(p - Vec3{0.0, 1.5, 0.0}) - 0.3));
    });
    options.ballSizes[0].growth = 0.5;
    EXPECT_GT(slow, expectSizes(options, [](Vec3) { return 0.4; }));
}

TEST(MeshPlanar, KeepsSizesByFormulaAndDistance)
{
    MeshOptions options = sized(0.4);
    options.sizeFormula = "0.03 + 0.1*(x + 2)";
    expectSizes(options, [](Vec3 p) { return std::min(0.4, 0.03 + 0.1 * (p.x + 2.0)); });
    options = sized(0.4);
    options.distanceSizes = {{"Edge2", 0.04, 0.2, 0.3}};
    const std::size_t plateau = expectSizes(
        options, [](Vec3 p) { return std::min(0.4, 0.04 + 0.2 * std::max(0.0, length(p) - 1.3)); });
    options.distanceSizes[0].plateau = 0.0;
    EXPECT_LT(
        expectSizes(options, [](Vec3 p) { return std::min(0.4, 0.04 + 0.2 * (length(p) - 1.0) + 1e-3); }),
        plateau);
    options = sized(0.4);
    options.distanceSizes = {{"Vertex1", 0.02, 0.1, 0.0}};
    expectSizes(options, [](Vec3 p) { return 0.02 + 0.1 * length(p - Vec3{2.0, 0.0, 0.0}) + 1e-3; });
}

TEST(MeshPlanar, WarnsOfAFormulaThatAsksForNothing)
{
    RunContext context;
    MeshOptions options = sized(0.4);
    options.sizeFormula = "max(x, 0.2) - 0.2";
    options.minSize = 0.05;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    ASSERT_TRUE(outcome.result);
    ASSERT_EQ(outcome.report.warnings.size(), 1u);
    EXPECT_NE(outcome.report.warnings[0].find("--size-formula is not a positive number at"),
              std::string::npos);
    options.sizeFormula = "0.2";
    EXPECT_TRUE(meshPlanar(annulus(), options, nullptr, 4, context).report.warnings.empty());
}

/// An annulus with a disc in it: the size of the disc holds inside of it and is left by the grading outside.
TEST(MeshPlanar, KeepsSizesOfOneFaceOfSeveral)
{
    PlanarCurveComplex complex = annulus();
    complex.curves[1].right =
        complex.curves[1].right == RegionId(0u) ? RegionId(2u) : complex.curves[1].right;
    complex.curves[1].left = complex.curves[1].left == RegionId(0u) ? RegionId(2u) : complex.curves[1].left;
    complex.regionNames = {"Face1", "Face2"};
    const auto trianglesOf = [&](const MeshOptions& options, std::uint32_t face) {
        RunContext context;
        const PlanarMeshOutcome outcome = meshPlanar(complex, options, nullptr, 4, context);
        EXPECT_TRUE(outcome.result);
        std::size_t count = 0;
        for (const MeshElement<3>& triangle : outcome.result->mesh.triangles)
            count += triangle.entity == EntityRef{2, face};
        return count;
    };
    MeshOptions options = sized(0.5);
    options.grading = 2.0;
    const std::size_t plainDisc = trianglesOf(options, 1);
    options.localSizes = {{"Face2", 0.05}};
    // A disc of area pi at 2.7 triangles per square of the size.
    EXPECT_NEAR(static_cast<double>(trianglesOf(options, 1)), 2.72 * std::numbers::pi / 0.0025, 500.0);
    EXPECT_LT(plainDisc, 300u);
    const std::size_t ring = trianglesOf(options, 0);
    EXPECT_LT(ring, 2000u);
    options.localSizes = {{"Face1", 0.05}};
    EXPECT_GT(trianglesOf(options, 0), 4 * ring);
}

TEST(MeshPlanar, RefusesASizeOnWhatIsNotThere)
{
    RunContext context;
    MeshOptions options = sized(0.5);
    options.localSizes = {{"Edge9", 0.05}};
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_EQ(outcome.report.failures[0].entity, "Edge9");
    options.localSizes.clear();
    options.distanceSizes = {{"Solid1", 0.05, 0.1, 0.0}};
    const PlanarMeshOutcome byDistance = meshPlanar(annulus(), options, nullptr, 4, context);
    ASSERT_EQ(byDistance.report.failures.size(), 1u);
    EXPECT_EQ(byDistance.report.failures[0].entity, "Solid1");
}

}  // namespace
}  // namespace mesher
