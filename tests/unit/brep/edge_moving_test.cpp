#include "brep/edge_moving.h"

#include "brep/analytic/line_curve.h"
#include "brep/displaced_curve.h"
#include "brep/occt/read_model.h"
#include "support/curve_contract.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

constexpr double kTolerance = 0.02;

TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, kind, parts);
    return parts;
}

/// Moves the curves of all edges, each another way, within a tolerance that the shape tells.
TopoDS_Shape loosened(const TopoDS_Shape& shape)
{
    const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
    const BRep_Builder builder;
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        TopLoc_Location location;
        double first = 0.0, last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
        const gp_Vec by(std::cos(2.0 * i), std::sin(3.0 * i), std::cos(5.0 * i));
        builder.UpdateEdge(
            edge, Handle(Geom_Curve)::DownCast(curve->Translated(0.9 * kTolerance / by.Magnitude() * by)),
            location, kTolerance);
        for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
            builder.UpdateVertex(end, kTolerance);
    }
    return shape;
}

/// Of edges from their faces.
double largestGap(const BrepModel& model)
{
    double gap = 0.0;
    for (const BrepFace& face : model.faces) {
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) gap = std::max(gap, coedge.gap);
        }
    }
    return gap;
}

TEST(DisplacedCurve, KeepsTheContract)
{
    const auto line =
        std::make_shared<LineCurve>(Vec3{1.0, 2.0, 3.0}, Vec3{0.0, 3.0, 4.0}, Interval{0.0, 2.0});
    std::vector<Vec3> by;
    for (double i = 0.0; i <= 8.0; ++i) by.push_back({0.02 * std::sin(i), 0.0, 0.01 * std::cos(0.7 * i)});
    const DisplacedCurve curve(line, {0.0, 2.0}, by);
    for (std::size_t i = 0; i < by.size(); ++i) {
        const double t = 0.25 * static_cast<double>(i);
        EXPECT_LT(length(curve.position(t) - line->position(t) - by[i]), 1e-15);
    }
    for (const std::string& broken : test::findBrokenPromises(curve, {0.0, 2.0}, 10.0))
        ADD_FAILURE() << broken;
}

/// The parameter curves on plane faces follow the edges, as readers compute those that files do not have.
void projectParameterCurves(const TopoDS_Shape& shape, const TopoDS_Edge& edge, const gp_Vec& by)
{
    const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
    const BRep_Builder builder;
    for (int f = 1; f <= faces.Extent(); ++f) {
        const TopoDS_Face& face = TopoDS::Face(faces(f));
        const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face));
        if (plane.IsNull() || !partsOf(face, TopAbs_EDGE).Contains(edge)) continue;
        double first = 0.0, last = 0.0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
        const gp_Vec2d shift(by * gp_Vec(plane->Position().XDirection()),
                             by * gp_Vec(plane->Position().YDirection()));
        builder.UpdateEdge(edge, Handle(Geom2d_Curve)::DownCast(curve->Translated(shift)), face, kTolerance);
    }
}

std::vector<BrepFaceId> allFaces(const BrepModel& model)
{
    std::vector<BrepFaceId> faces;
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) faces.push_back(BrepFaceId(f));
    return faces;
}

/// Of the edges of a box from the straight lines between their vertices.
double largestBend(const BrepModel& model)
{
    double bend = 0.0;
    for (const BrepEdge& edge : model.edges) {
        const Vec3 a = model.vertices[edge.first].position, b = model.vertices[edge.last].position;
        for (const double share : {0.1, 0.5, 0.8}) {
            const Vec3 place = edge.curve->position(edge.part.at(share));
            bend = std::max(bend, length(place - a - share * (b - a)));
        }
    }
    return bend;
}

TEST(EdgeMoving, PutsEdgesWhereParameterCurvesAgree)
{
    auto read = readModelFromShape(loosened(BRepPrimAPI_MakeBox(3.0, 2.0, 1.0).Shape()));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_GT(largestBend(read->model), 0.01);
    EXPECT_EQ(moveEdgesOntoFaces(read->model, allFaces(read->model)).size(), 12u);
    EXPECT_LT(largestGap(read->model), 1e-6);
    EXPECT_LT(largestBend(read->model), 1e-6);
}

TEST(EdgeMoving, PutsEdgesWhereFacesMeetIfParameterCurvesAreOffAsWell)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(3.0, 2.0, 1.0).Shape();
    const TopTools_IndexedMapOfShape edges = partsOf(box, TopAbs_EDGE);
    const BRep_Builder builder;
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        TopLoc_Location location;
        double first = 0.0, last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
        const gp_Vec by(0.009, 0.006, -0.004);
        builder.UpdateEdge(edge, Handle(Geom_Curve)::DownCast(curve->Translated(by)), location, kTolerance);
        projectParameterCurves(box, edge, by);
    }
    auto read = readModelFromShape(box);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_GT(largestGap(read->model), 1e-3);
    moveEdgesOntoFaces(read->model, allFaces(read->model));
    EXPECT_LT(largestGap(read->model), 1e-6);
    EXPECT_LT(largestBend(read->model), 1e-6);
}

TEST(EdgeMoving, LeavesEdgesOnTheirFacesAndOfOtherFacesAsTheyAre)
{
    const TopoDS_Shape block =
        BRepAlgoAPI_Cut(
            BRepPrimAPI_MakeBox(3.0, 2.0, 1.0).Shape(),
            BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1.0, 1.0, -1.0), gp_Dir(0.1, 0.0, 1.0)), 0.4, 3.0).Shape())
            .Shape();
    auto read = readModelFromShape(block);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_TRUE(moveEdgesOntoFaces(read->model, allFaces(read->model)).empty());
    auto loose = readModelFromShape(loosened(BRepPrimAPI_MakeBox(3.0, 2.0, 1.0).Shape()));
    ASSERT_TRUE(loose) << describe(loose.error());
    EXPECT_EQ(moveEdgesOntoFaces(loose->model, {BrepFaceId(0)}).size(), 4u);
}

}  // namespace
}  // namespace mesher
