#include "occt_models.h"

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax1.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <numbers>

namespace mesher::test {

namespace {

Handle(Geom_BSplineSurface) wavySurface()
{
    TColgp_Array2OfPnt points(1, 7, 1, 6);
    for (int i = 1; i <= 7; ++i) {
        for (int j = 1; j <= 6; ++j) {
            points.SetValue(i, j, gp_Pnt(i, 1.2 * j, 0.6 * std::sin(0.9 * i) * std::cos(0.7 * j)));
        }
    }
    return GeomAPI_PointsToBSplineSurface(points).Surface();
}

TopoDS_Edge wavyEdge()
{
    TColgp_Array1OfPnt points(1, 6);
    for (int i = 1; i <= 6; ++i) points.SetValue(i, gp_Pnt(2.0 + 0.5 * std::sin(1.3 * i), 0.0, i));
    return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
}

TopoDS_Shape filletedBox()
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(4.0, 3.0, 2.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
        fillet.Add(0.4, TopoDS::Edge(edge.Current()));
    return fillet.Shape();
}

TopoDS_Shape mirrored(const TopoDS_Shape& shape)
{
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, 1.0, 0.5)));
    return BRepBuilderAPI_Transform(shape, mirror, false).Shape();
}

TopoDS_Shape placed(const TopoDS_Shape& shape)
{
    gp_Trsf turn, shift;
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(1.0, 2.0, 3.0)), 0.7);
    shift.SetTranslation(gp_Vec(10.0, -20.0, 5.0));
    return shape.Moved(TopLoc_Location(shift * turn));
}

}  // namespace

TopoDS_Shape drilledPlate()
{
    TopoDS_Shape plate = BRepPrimAPI_MakeBox(6.0, 4.0, 0.5).Shape();
    for (int i = 0; i < 3; ++i) {
        const gp_Ax2 axis(gp_Pnt(1.0 + 2.0 * i, 2.0, -1.0), gp_Dir(0.0, 0.1 * i, 1.0));
        plate = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(axis, 0.4, 3.0).Shape()).Shape();
    }
    return plate;
}

TopoDS_Shape gluedBoxes()
{
    TopTools_ListOfShape boxes;
    boxes.Append(BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), 1.0, 1.0, 1.0).Shape());
    boxes.Append(BRepPrimAPI_MakeBox(gp_Pnt(1.0, 0.0, 0.0), 2.0, 1.0, 1.0).Shape());
    BRepAlgoAPI_BuilderAlgo glue;
    glue.SetArguments(boxes);
    glue.Build();
    return glue.Shape();
}

std::vector<std::pair<std::string, TopoDS_Shape>> kernelModels()
{
    const double turn = 2.0 * std::numbers::pi;
    return {
        {"box", BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()},
        {"cylinder", BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape()},
        {"part of a cylinder", BRepPrimAPI_MakeCylinder(1.0, 3.0, 1.5).Shape()},
        {"cone", BRepPrimAPI_MakeCone(2.0, 1.0, 3.0).Shape()},
        {"pointed cone", BRepPrimAPI_MakeCone(2.0, 0.0, 3.0).Shape()},
        {"sphere", BRepPrimAPI_MakeSphere(2.0).Shape()},
        {"part of a sphere", BRepPrimAPI_MakeSphere(2.0, -0.5, 1.0, 2.0).Shape()},
        {"torus", BRepPrimAPI_MakeTorus(3.0, 1.0).Shape()},
        {"part of a torus", BRepPrimAPI_MakeTorus(3.0, 1.0, 0.5, 2.5, 1.0).Shape()},
        {"filleted box", filletedBox()},
        {"mirrored filleted box", mirrored(filletedBox())},
        {"mirrored cone", mirrored(BRepPrimAPI_MakeCone(2.0, 1.0, 3.0).Shape())},
        {"placed torus", placed(BRepPrimAPI_MakeTorus(3.0, 1.0).Shape())},
        {"spline face", BRepBuilderAPI_MakeFace(wavySurface(), 1e-7).Shape()},
        {"offset face", BRepBuilderAPI_MakeFace(new Geom_OffsetSurface(wavySurface(), 0.2), 1e-7).Shape()},
        {"revolved spline", BRepPrimAPI_MakeRevol(wavyEdge(), gp_Ax1(), turn).Shape()},
        {"extruded spline", BRepPrimAPI_MakePrism(wavyEdge(), gp_Vec(0.3, 2.0, 0.1)).Shape()},
        {"drilled plate", drilledPlate()},
        {"glued boxes", gluedBoxes()}};
}

TopoDS_Shape cylinderWithFalsePole()
{
    constexpr double kRadius = 1.0, kHeight = 2.0;
    const TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(kRadius, kHeight).Solid();
    const BRep_Builder builder;
    for (TopExp_Explorer part(solid, TopAbs_FACE); part.More(); part.Next()) {
        const TopoDS_Face face = TopoDS::Face(part.Current());
        if (BRep_Tool::Surface(face)->IsKind(STANDARD_TYPE(Geom_Plane))) continue;
        for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
            const TopoDS_Vertex vertex = TopExp::FirstVertex(TopoDS::Edge(at.Current()));
            if (!TopExp::LastVertex(TopoDS::Edge(at.Current())).IsSame(vertex)) continue;
            if (BRep_Tool::Pnt(vertex).Z() < 0.5 * kHeight) continue;
            TopoDS_Edge pole;
            builder.MakeEdge(pole);
            builder.UpdateEdge(pole, new Geom2d_Line(gp_Pnt2d(0.0, kHeight), gp_Dir2d(1.0, 0.0)), face,
                               Precision::Confusion());
            builder.Range(pole, 0.0, 2.0 * std::numbers::pi);
            builder.Degenerated(pole, true);
            builder.Add(pole, vertex.Oriented(TopAbs_FORWARD));
            builder.Add(pole, vertex.Oriented(TopAbs_REVERSED));
            builder.UpdateVertex(vertex, 2.0 * kRadius);
            TopoDS_Wire wire = TopoDS::Wire(TopExp_Explorer(face, TopAbs_WIRE).Current());
            wire.Free(true);
            builder.Add(wire, pole);
            return solid;
        }
    }
    return solid;
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& points, bool isClosed)
{
    BRepBuilderAPI_MakePolygon wire;
    for (const gp_Pnt& p : points) wire.Add(p);
    if (isClosed) wire.Close();
    return wire.Wire();
}

TopoDS_Face rawFace(const TopoDS_Wire& wire)
{
    const BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, new Geom_Plane(gp_Pln()), 1e-7);
    builder.Add(face, wire);
    return face;
}

}  // namespace mesher::test
