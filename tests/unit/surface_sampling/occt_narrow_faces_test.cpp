#include "brep/occt/read_model.h"
#include "surface_sampling/sample_surface.h"
#include "surface_sampling/surface_check.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {
namespace {

SurfaceSample sampleOf(const BrepModel& model, const SurfaceSamplingOptions& options = {})
{
    RunContext context;
    auto sample = sampleSurface(model, options, context);
    if (!sample) {
        ADD_FAILURE() << describe(sample.error());
        return {};
    }
    for (const auto& [face, error] : sample->failures) ADD_FAILURE() << describe(error);
    return std::move(sample).value();
}

/// Degrees.
double smallestAngle(const SurfaceMesh& mesh)
{
    double least = 180.0;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        const auto at = [&](std::size_t i) { return mesh.nodes[facet.node[i % 3]].position; };
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = at(i + 1) - at(i), b = at(i + 2) - at(i);
            least = std::min(least, std::atan2(length(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi);
        }
    }
    return least;
}

TEST(NarrowFaces, OfATinyTiltedHoleGetGoodFacetsToTheirRims)
{
    // The rim runs with the parameters of the wall, but for a fortieth of its length.
    for (const double tilt : {0.08, 0.13}) {
        const gp_Ax2 axis(gp_Pnt(0.5, 0.5, -0.1), gp_Dir(std::sin(tilt), 0.0, std::cos(tilt)));
        auto read = readModelFromShape(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(1.0, 1.0, 0.5).Shape(),
                                                       BRepPrimAPI_MakeCylinder(axis, 0.003, 0.8).Shape())
                                           .Shape());
        ASSERT_TRUE(read) << describe(read.error());
        const SurfaceSample sample = sampleOf(read->model);
        EXPECT_EQ(checkSurfaceMesh(read->model, sample.surface->mesh()).problem(), "");
        EXPECT_GT(smallestAngle(sample.surface->mesh()), 20.0) << tilt;
        EXPECT_LT(sample.counts.refinement.leftForResolution, 10u) << tilt;
    }
}

/// A part of a turn of a block with a horn sunk into it: its wall is tangent to the axis in a pole, where all edges of the wall meet
/// at an angle of zero.
TopoDS_Shape hornInBlock(double degrees)
{
    const gp_Pnt rim(2.0, 0.0, 0.0), pole(0.0, 0.0, 0.0), below(0.0, 0.0, -1.0), corner(2.0, 0.0, -1.0);
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(rim, gp_Pnt(1.0, 0.0, 1.0), pole).Value()));
    wire.Add(BRepBuilderAPI_MakeEdge(pole, below));
    wire.Add(BRepBuilderAPI_MakeEdge(below, corner));
    wire.Add(BRepBuilderAPI_MakeEdge(corner, rim));
    const gp_Ax1 axis(pole, gp_Dir(0.0, 0.0, 1.0));
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), axis,
                                 degrees * std::numbers::pi / 180.0);
}

TEST(NarrowFaces, EndInAPoleWhereTheirEdgesMeetAtNoAngle)
{
    for (const double degrees : {20.0, 100.0, 180.0, 260.0}) {
        SCOPED_TRACE(degrees);
        auto read = readModelFromShape(hornInBlock(degrees));
        ASSERT_TRUE(read) << describe(read.error());
        SurfaceSamplingOptions options;
        options.curves.segmentsPerTurn = options.facets.elementsPerTurn = 12.0;
        const SurfaceSample sample = sampleOf(read->model, options);
        EXPECT_EQ(checkSurfaceMesh(read->model, sample.surface->mesh()).problem(), "");
        EXPECT_EQ(sample.counts.certificate.errors.size(), 0u);
        // One fan at the pole, not ever smaller facets.
        EXPECT_LT(sample.counts.facets, 4000u);
    }
}

TEST(NarrowFaces, OfASpindlesSectorEndInBothTips)
{
    const gp_Pnt tip(0.0, 0.0, 0.0), rim(2.1, 0.0, 2.7), top(0.0, 0.0, 5.0);
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(tip, rim));
    wire.Add(BRepBuilderAPI_MakeEdge(rim, top));
    wire.Add(BRepBuilderAPI_MakeEdge(top, tip));
    const gp_Ax1 axis(tip, gp_Dir(0.0, 0.0, 1.0));
    for (const double degrees : {20.0, 60.0, 75.0, 90.0, 200.0}) {
        SCOPED_TRACE(degrees);
        auto read = readModelFromShape(BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(),
                                                             axis, degrees * std::numbers::pi / 180.0)
                                           .Shape());
        ASSERT_TRUE(read) << describe(read.error());
        const SurfaceSample sample = sampleOf(read->model);
        EXPECT_EQ(checkSurfaceMesh(read->model, sample.surface->mesh()).problem(), "");
    }
}

}  // namespace
}  // namespace mesher
