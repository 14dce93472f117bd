#include "pipeline/mesh_planar.h"

#include "mesh/mesh_check.h"
#include "support/planar_builder.h"

#include <gtest/gtest.h>

#include <cmath>
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
    MeshOptions options = sized(0.01);
    options.maxElements = 1000;
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    EXPECT_EQ(outcome.report.status, MeshReport::Status::Failed);
    EXPECT_EQ(outcome.report.stopReason, StopReason::ElementLimit);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_NE(describe(outcome.report.failures[0]).find("1000 elements"), std::string::npos);
    ASSERT_TRUE(outcome.result);
    EXPECT_TRUE(checkMesh(outcome.result->mesh).isValid());
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

TEST(MeshPlanar, RefusesASizeOnWhatIsNotThere)
{
    RunContext context;
    MeshOptions options = sized(0.5);
    options.localSizes = {{"Edge9", 0.05}};
    const PlanarMeshOutcome outcome = meshPlanar(annulus(), options, nullptr, 4, context);
    ASSERT_EQ(outcome.report.failures.size(), 1u);
    EXPECT_EQ(outcome.report.failures[0].entity, "Edge9");
}

}  // namespace
}  // namespace mesher
