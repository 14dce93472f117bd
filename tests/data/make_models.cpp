// Writes the models that the tests of the program and the demonstration read, by Open CASCADE:
// make_models TEST-FOLDER DEMO-FOLDER

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

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
