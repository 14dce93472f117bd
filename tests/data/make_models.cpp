// Writes the models that the tests of the program and the demonstration read, by Open CASCADE:
// make_models TEST-FOLDER DEMO-FOLDER

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

constexpr double kPi = std::numbers::pi;

TopoDS_Wire polygon(const std::vector<gp_Pnt>& points, bool isClosed)
{
    BRepBuilderAPI_MakeWire wire;
    std::vector<TopoDS_Vertex> vertices;
    BRep_Builder builder;
    for (const gp_Pnt& p : points) {
        TopoDS_Vertex vertex;
        builder.MakeVertex(vertex, p, 1e-7);
        vertices.push_back(vertex);
    }
    const std::size_t edges = points.size() - (isClosed ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i)
        wire.Add(BRepBuilderAPI_MakeEdge(vertices[i], vertices[(i + 1) % points.size()]).Edge());
    return wire.Wire();
}

/// A face of the plane z = 0 without any check of its wires.
TopoDS_Face rawFace(const std::vector<TopoDS_Wire>& wires)
{
    BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, new Geom_Plane(gp_Pln()), 1e-7);
    for (const TopoDS_Wire& wire : wires) builder.Add(face, wire);
    return face;
}

TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& shapes)
{
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
    return compound;
}

TopoDS_Wire circle(double x, double y, double radius)
{
    const gp_Circ circ(gp_Ax2(gp_Pnt(x, y, 0.0), gp_Dir(0.0, 0.0, 1.0)), radius);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circ).Edge()).Wire();
}

using Radius = std::function<double(double)>;

Handle(TColgp_HArray1OfPnt) onRadius(const Radius& radius, double turn, int points)
{
    Handle(TColgp_HArray1OfPnt) array = new TColgp_HArray1OfPnt(1, points);
    for (int i = 0; i < points; ++i) {
        const double angle = turn * i / (points - 1);
        array->SetValue(i + 1, gp_Pnt(radius(angle) * std::cos(angle), radius(angle) * std::sin(angle), 0.0));
    }
    return array;
}

Handle(Geom_BSplineCurve) interpolated(const Handle(TColgp_HArray1OfPnt) & points, bool isPeriodic)
{
    GeomAPI_Interpolate interpolate(points, isPeriodic, 1e-9);
    interpolate.Perform();
    return interpolate.Curve();
}

/// A closed spline about the origin.
TopoDS_Wire closedSpline(const Radius& radius)
{
    constexpr int kPoints = 24;
    const Handle(TColgp_HArray1OfPnt) points = onRadius(radius, 2.0 * kPi * (kPoints - 1) / kPoints, kPoints);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolated(points, true)).Edge()).Wire();
}

/// The casing of a pump: a spiral whose ends a straight tongue joins.
TopoDS_Wire volute(double least, double growth)
{
    const Radius radius = [=](double angle) { return least + growth * angle / (2.0 * kPi); };
    const Handle(TColgp_HArray1OfPnt) points = onRadius(radius, 2.0 * kPi, 25);
    const TopoDS_Edge spiral = BRepBuilderAPI_MakeEdge(interpolated(points, false)).Edge();
    TopoDS_Vertex first, last;
    for (TopExp_Explorer it(spiral, TopAbs_VERTEX); it.More(); it.Next()) {
        (it.Current().Orientation() == TopAbs_FORWARD ? first : last) = TopoDS::Vertex(it.Current());
    }
    const TopoDS_Edge tongue =
        BRepBuilderAPI_MakeEdge(TopoDS::Vertex(last.Oriented(TopAbs_FORWARD)), first).Edge();
    return BRepBuilderAPI_MakeWire(spiral, tongue).Wire();
}

TopoDS_Wire roundedRectangle(double halfWidth, double halfHeight, double radius)
{
    BRepBuilderAPI_MakeWire wire;
    const double x = halfWidth - radius, y = halfHeight - radius;
    const std::vector<gp_Pnt> centres = {{x, y, 0.0}, {-x, y, 0.0}, {-x, -y, 0.0}, {x, -y, 0.0}};
    const auto onCorner = [&](std::size_t corner, double quarter) {
        const double angle = 0.5 * kPi * (static_cast<double>(corner) + quarter);
        return gp_Pnt(centres[corner].X() + radius * std::round(std::cos(angle)),
                      centres[corner].Y() + radius * std::round(std::sin(angle)), 0.0);
    };
    for (std::size_t i = 0; i < 4; ++i) {
        const gp_Circ circ(gp_Ax2(centres[i], gp_Dir(0.0, 0.0, 1.0)), radius);
        wire.Add(BRepBuilderAPI_MakeEdge(circ, onCorner(i, 0.0), onCorner(i, 1.0)).Edge());
        wire.Add(BRepBuilderAPI_MakeEdge(onCorner(i, 1.0), onCorner((i + 1) % 4, 0.0)).Edge());
    }
    return wire.Wire();
}

TopoDS_Wire reversed(const TopoDS_Wire& wire) { return TopoDS::Wire(wire.Reversed()); }

/// The gasket of a pump: plate, bead and liner, which share their edges, around the casing's opening.
TopoDS_Shape gasket()
{
    const TopoDS_Wire beadOutside = closedSpline([](double a) { return 31.0 + 3.0 * std::cos(2.0 * a); });
    const TopoDS_Wire beadInside = closedSpline([](double a) { return 28.0 + 3.0 * std::cos(2.0 * a); });
    std::vector<TopoDS_Wire> plate = {roundedRectangle(60.0, 40.0, 14.0), reversed(beadOutside)};
    for (const double x : {-46.0, 46.0}) {
        for (const double y : {-26.0, 26.0}) plate.push_back(reversed(circle(x, y, 5.0)));
    }
    for (const double y : {-34.0, 34.0}) plate.push_back(reversed(circle(0.0, y, 3.0)));
    return compoundOf({rawFace(plate), rawFace({beadOutside, reversed(beadInside)}),
                       rawFace({beadInside, reversed(volute(16.0, 8.0))})});
}

TopoDS_Shape roundBar(double x, double y, double z, double radius, double height)
{
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0.0, 0.0, 1.0)), radius, height).Shape();
}

/// Rounds the edges that `isChosen` says, by the middle of each.
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius,
                     const std::function<bool(gp_Pnt, gp_Vec)>& isChosen)
{
    BRepFilletAPI_MakeFillet fillet(shape);
    for (TopExp_Explorer edges(shape, TopAbs_EDGE); edges.More(); edges.Next()) {
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges.Current()), first, last);
        if (curve.IsNull()) continue;
        gp_Pnt middle;
        gp_Vec tangent;
        curve->D1(0.5 * (first + last), middle, tangent);
        if (isChosen(middle, tangent)) fillet.Add(radius, TopoDS::Edge(edges.Current()));
    }
    return fillet.Shape();
}

/// From the boss down to the plate, 6 mm thick, in the plane y = 0; `side` is 1 or -1.
TopoDS_Shape rib(double side)
{
    const TopoDS_Wire outline = polygon({{side * 10.0, -3.0, 4.0},
                                         {side * 38.0, -3.0, 4.0},
                                         {side * 38.0, -3.0, 10.0},
                                         {side * 10.0, -3.0, 27.0}},
                                        true);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline).Face(), gp_Vec(0.0, 6.0, 0.0)).Shape();
}

/// A bearing bracket, 100 mm x 60 mm x 34 mm: plate with rounded corners and four holes, bored boss with a fillet, two ribs.
TopoDS_Shape bracket()
{
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-50.0, -30.0, 0.0), 100.0, 60.0, 10.0).Shape();
    const TopoDS_Shape plate =
        rounded(block, 10.0, [](gp_Pnt, gp_Vec tangent) { return std::abs(tangent.Z()) > 0.5; });
    const TopoDS_Shape withBoss = BRepAlgoAPI_Fuse(plate, roundBar(0.0, 0.0, 5.0, 16.0, 29.0)).Shape();
    TopoDS_Shape shape = rounded(withBoss, 4.0, [](gp_Pnt middle, gp_Vec) {
        return std::abs(middle.Z() - 10.0) < 1e-6 &&
               std::abs(std::hypot(middle.X(), middle.Y()) - 16.0) < 1e-6;
    });
    for (const double side : {-1.0, 1.0}) shape = BRepAlgoAPI_Fuse(shape, rib(side)).Shape();
    shape = BRepAlgoAPI_Cut(shape, roundBar(0.0, 0.0, -1.0, 9.0, 40.0)).Shape();
    for (const double x : {-40.0, 40.0}) {
        for (const double y : {-20.0, 20.0})
            shape = BRepAlgoAPI_Cut(shape, roundBar(x, y, -1.0, 4.5, 20.0)).Shape();
    }
    ShapeUpgrade_UnifySameDomain unify(shape);
    unify.Build();
    return TopExp_Explorer(unify.Shape(), TopAbs_SOLID).Current();
}

TopoDS_Shape wallOfCylinder()
{
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
    return TopExp_Explorer(cylinder, TopAbs_FACE).Current();
}

/// Two unit squares on the edge x = 0: in the plane z = 0, and the other turned up from it.
TopoDS_Shape angledSquares()
{
    const TopoDS_Wire flat = polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, true);
    const TopoDS_Wire upright = polygon({{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}, true);
    return compoundOf({rawFace({flat}), BRepBuilderAPI_MakeFace(upright, true).Face()});
}

bool write(const TopoDS_Shape& shape, const std::string& path)
{
    if (BRepTools::Write(shape, path.c_str())) return true;
    std::fprintf(stderr, "make_models: %s cannot be written\n", path.c_str());
    return false;
}

bool writeStep(const TopoDS_Shape& shape, const std::string& path)
{
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.product.name", "bracket");
    if (writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
        writer.Write(path.c_str()) == IFSelect_RetDone) {
        return true;
    }
    std::fprintf(stderr, "make_models: %s cannot be written\n", path.c_str());
    return false;
}

}  // namespace

int main(int count, char** arguments)
{
    if (count != 3) {
        std::fputs("usage: make_models TEST-FOLDER DEMO-FOLDER\n", stderr);
        return 2;
    }
    const std::string tests = std::string(arguments[1]) + "/", demos = std::string(arguments[2]) + "/";
    const std::vector<gp_Pnt> bowTie = {{0, 0, 0}, {2, 1, 0}, {2, 0, 0}, {0, 2, 0}};
    const std::vector<gp_Pnt> onLine = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
    const std::vector<gp_Pnt> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const bool isWritten = write(gasket(), demos + "gasket.brep") &&
                           write(bracket(), demos + "bracket.brep") &&
                           writeStep(bracket(), demos + "bracket.step") &&
                           write(rawFace({polygon(square, false)}), tests + "open_wire.brep") &&
                           write(rawFace({polygon(bowTie, true)}), tests + "crossing_wire.brep") &&
                           write(rawFace({polygon(onLine, true)}), tests + "no_area.brep") &&
                           write(rawFace({}), tests + "no_wire.brep") &&
                           write(polygon(square, true), tests + "wire_only.brep") &&
                           write(compoundOf({}), tests + "nothing.brep") &&
                           write(wallOfCylinder(), tests + "cylinder_wall.brep") &&
                           write(angledSquares(), tests + "angled_squares.brep");
    return isWritten ? 0 : 1;
}
