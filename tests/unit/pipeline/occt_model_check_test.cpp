#include "pipeline/model_check.h"

#include "brep/occt/read_model.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace mesher::test {
namespace {

/// A body of revolution with a brim that runs out to a thin edge, all of one face.
TopoDS_Shape brimmedBody()
{
    constexpr std::array<std::array<double, 2>, 8> kPoles = {{{0.0, 0.0},
                                                              {6.1879, 0.9564},
                                                              {6.1043, 0.7279},
                                                              {2.6308, 1.2261},
                                                              {1.1339, 3.1732},
                                                              {4.3596, 3.989},
                                                              {5.1987, 4.2539},
                                                              {0.0, 4.6804}}};
    constexpr std::array<double, 6> kKnots = {0.0, 4.96, 7.75, 8.86, 10.81, 14.3};
    TColgp_Array1OfPnt poles(1, 8);
    for (int i = 1; i <= 8; ++i) {
        const auto& [radius, height] = kPoles[static_cast<std::size_t>(i - 1)];
        poles(i) = gp_Pnt(radius, 0.0, height);
    }
    TColStd_Array1OfReal knots(1, 6);
    TColStd_Array1OfInteger multiplicities(1, 6);
    for (int i = 1; i <= 6; ++i) {
        knots(i) = kKnots[static_cast<std::size_t>(i - 1)];
        multiplicities(i) = i == 1 || i == 6 ? 4 : 1;
    }
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, multiplicities, 3)));
    wire.Add(BRepBuilderAPI_MakeEdge(poles(8), poles(1)));
    const gp_Ax1 axis(gp_Pnt(), gp_Dir(0.0, 0.0, 1.0));
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), axis).Shape();
}

/// Triangles between places of the body's face, without parameters, as from a file. None at its poles.
ClassifiedMesh meshOf(const BrepModel& model)
{
    constexpr std::uint32_t kAround = 30, kAlong = 150;
    ClassifiedMesh mesh;
    const BrepFace& face = model.faces[BrepFaceId(0)];
    const EntityRef entity{2, 0};
    for (std::uint32_t i = 0; i < kAround; ++i) {
        for (std::uint32_t j = 0; j < kAlong; ++j) {
            const Vec2 uv{face.boundsU.at((i + 0.3) / kAround), face.boundsV.at((j + 0.5) / kAlong)};
            mesh.nodes.push_back({face.surface->position(uv), entity, {}});
        }
    }
    for (std::uint32_t i = 0; i + 1 < kAround; ++i) {
        for (std::uint32_t j = 0; j + 1 < kAlong; ++j) {
            const std::uint32_t a = i * kAlong + j, b = a + kAlong;
            mesh.triangles.push_back({{NodeId(a), NodeId(b), NodeId(a + 1)}, entity});
            mesh.triangles.push_back({{NodeId(b), NodeId(b + 1), NodeId(a + 1)}, entity});
        }
    }
    return mesh;
}

TEST(ModelCheck, FindsTheSheetOfAFaceThatRunsCloseToItself)
{
    const auto read = readModelFromShape(brimmedBody());
    ASSERT_TRUE(read) << describe(read.error());
    ClassifiedMesh mesh = meshOf(read->model);
    const ModelCheckReport report = checkAgainstModel(mesh, read->model);
    EXPECT_EQ(report.nodesOff, 0u) << report.largestDistance[2];
    // What is off stays off, whatever its neighbours say.
    mesh.nodes[NodeId(700)].position.z += 1e-3;
    EXPECT_EQ(checkAgainstModel(mesh, read->model).nodesOff, 1u);
}

TEST(ModelCheck, KnowsWhatRoundingDoesFarFromTheOrigin)
{
    gp_Trsf away;
    away.SetTranslation(gp_Vec(4e8, -3e8, 5e8));
    const auto read = readModelFromShape(BRepBuilderAPI_Transform(brimmedBody(), away, true).Shape());
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(checkAgainstModel(meshOf(read->model), read->model).nodesOff, 0u);
}

}  // namespace
}  // namespace mesher::test
