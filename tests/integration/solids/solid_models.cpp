// Writes the solids that the tests of this folder mesh, good and bad ones, by Open CASCADE: solid_models FOLDER

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) { return BRepPrimAPI_MakeBox(low, high).Shape(); }

TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z)
{
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(x, y, z));
    return BRepBuilderAPI_Transform(shape, shift, true).Shape();
}

TopoDS_Shape scaled(const TopoDS_Shape& shape, double factor)
{
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(), factor);
    return BRepBuilderAPI_Transform(shape, scale, true).Shape();
}

TopoDS_Compound together(const std::vector<TopoDS_Shape>& shapes)
{
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
    return compound;
}

TopoDS_Shape boxWithHole()
{
    const gp_Ax2 axis(gp_Pnt(2.0, 1.5, -1.0), gp_Dir(0.0, 0.0, 1.0));
    return BRepAlgoAPI_Cut(box({0, 0, 0}, {4, 3, 2}), BRepPrimAPI_MakeCylinder(axis, 0.7, 4.0).Shape())
        .Shape();
}

/// A ball with a bore and a corner cut out.
TopoDS_Shape cutBall()
{
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(3.0).Shape();
    const TopoDS_Shape open = BRepAlgoAPI_Cut(ball, box({0.3, 0.2, 0.1}, {5, 5, 5})).Shape();
    const gp_Ax2 axis(gp_Pnt(-1.0, -1.0, -5.0), gp_Dir(0.0, 0.0, 1.0));
    return BRepAlgoAPI_Cut(open, BRepPrimAPI_MakeCylinder(axis, 0.6, 10.0).Shape()).Shape();
}

TopoDS_Wire wavyRing(double radius, double height, int waves)
{
    constexpr int kPoints = 16;
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kPoints;
        const double r = radius * (1.0 + 0.15 * std::cos(waves * turn));
        points->SetValue(i + 1, gp_Pnt(r * std::cos(turn), r * std::sin(turn), height));
    }
    GeomAPI_Interpolate interpolate(points, true, 1e-9);
    interpolate.Perform();
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolate.Curve()).Edge()).Wire();
}

TopoDS_Shape loft()
{
    BRepOffsetAPI_ThruSections sections(true, false, 1e-7);
    sections.AddWire(wavyRing(2.0, 0.0, 2));
    sections.AddWire(wavyRing(1.4, 2.0, 3));
    sections.AddWire(wavyRing(1.8, 4.0, 2));
    return sections.Shape();
}

/// Boxes with the faces between them in common.
TopoDS_Shape glued(const std::vector<TopoDS_Shape>& shapes)
{
    TopTools_ListOfShape list;
    for (const TopoDS_Shape& shape : shapes) list.Append(shape);
    BRepAlgoAPI_BuilderAlgo glue;
    glue.SetArguments(list);
    glue.Build();
    return glue.Shape();
}

TopoDS_Shell shellOf(const std::vector<TopoDS_Shape>& faces)
{
    const BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (const TopoDS_Shape& face : faces) builder.Add(shell, face);
    return shell;
}

TopoDS_Solid solidOf(const TopoDS_Shell& shell)
{
    const BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    return solid;
}

std::vector<TopoDS_Shape> facesOf(const TopoDS_Shape& shape)
{
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
    return faces;
}

TopoDS_Shape withoutLid()
{
    std::vector<TopoDS_Shape> faces = facesOf(box({0, 0, 0}, {1, 2, 3}));
    faces.pop_back();
    return solidOf(shellOf(faces));
}

TopoDS_Shape shellOnly()
{
    const std::vector<TopoDS_Shape> faces = facesOf(box({0, 0, 0}, {1, 2, 3}));
    return shellOf(faces);
}

/// Each face with edges of its own.
std::vector<TopoDS_Shape> apart(const std::vector<TopoDS_Shape>& faces)
{
    std::vector<TopoDS_Shape> copies;
    for (const TopoDS_Shape& face : faces) copies.push_back(BRepBuilderAPI_Copy(face).Shape());
    return copies;
}

TopoDS_Shape openBoxOfFaces()
{
    std::vector<TopoDS_Shape> faces = apart(facesOf(box({0, 0, 0}, {1, 2, 3})));
    faces.pop_back();
    return together(faces);
}

TopoDS_Shape quadrangle(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const gp_Pnt& d)
{
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakePolygon(a, b, c, d, true).Wire(), true).Face();
}

/// An open box whose lid is two faces that end where no other face has a vertex.
TopoDS_Shape boxWithLidInHalves()
{
    std::vector<TopoDS_Shape> faces = facesOf(openBoxOfFaces());
    faces.push_back(quadrangle({0, 0, 3}, {1, 0, 3}, {1, 0.7, 3}, {0, 0.7, 3}));
    faces.push_back(quadrangle({0, 0.7, 3}, {1, 0.7, 3}, {1, 2, 3}, {0, 2, 3}));
    return together(faces);
}

TopoDS_Shape hollowOfFaces()
{
    std::vector<TopoDS_Shape> faces = apart(facesOf(box({0, 0, 0}, {4, 4, 4})));
    for (const TopoDS_Shape& face : apart(facesOf(box({1, 1, 1}, {3, 3, 3})))) faces.push_back(face);
    return together(faces);
}

/// A solid with a face in it that bounds nothing.
TopoDS_Shape boxWithInnerFace()
{
    const BRep_Builder builder;
    TopoDS_Shape solid = box({0, 0, 0}, {2, 2, 2});
    builder.Add(solid, shellOf({quadrangle({0.5, 0.5, 1}, {1.5, 0.5, 1}, {1.5, 1.5, 1}, {0.5, 1.5, 1})
                                    .Oriented(TopAbs_INTERNAL)}));
    return solid;
}

/// A solid, and beside it a face, an edge and a vertex.
TopoDS_Shape boxWithStrays()
{
    return together({box({0, 0, 0}, {1, 1, 1}), quadrangle({2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}),
                     BRepBuilderAPI_MakeEdge(gp_Pnt(4, 0, 0), gp_Pnt(5, 0, 0)).Edge(),
                     BRepBuilderAPI_MakeVertex(gp_Pnt(6, 0, 0)).Vertex()});
}

TopoDS_Shape emptySolid()
{
    TopoDS_Solid nothing;
    BRep_Builder().MakeSolid(nothing);
    return nothing;
}

/// A closed shell of triangles and quadrangles between corners, each edge made once.
class Polyhedron
{
public:
    explicit Polyhedron(const std::vector<gp_Pnt>& corners)
    {
        const BRep_Builder builder;
        for (const gp_Pnt& corner : corners) {
            TopoDS_Vertex vertex;
            builder.MakeVertex(vertex, corner, 1e-7);
            vertices_.push_back(vertex);
        }
    }

    TopoDS_Shape face(const std::vector<int>& corners)
    {
        BRepBuilderAPI_MakeWire wire;
        for (std::size_t i = 0; i < corners.size(); ++i)
            wire.Add(edge(corners[i], corners[(i + 1) % corners.size()]));
        return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
    }

private:
    TopoDS_Edge edge(int a, int b)
    {
        const std::pair<int, int> key = std::minmax(a, b);
        auto known =
            std::find_if(edges_.begin(), edges_.end(), [&](const auto& e) { return e.first == key; });
        if (known == edges_.end()) {
            const auto at = [&](int i) { return vertices_[static_cast<std::size_t>(i)]; };
            const TopoDS_Edge made = BRepBuilderAPI_MakeEdge(at(key.first), at(key.second)).Edge();
            known = edges_.insert(edges_.end(), {key, made});
        }
        return a < b ? known->second : TopoDS::Edge(known->second.Reversed());
    }

    std::vector<TopoDS_Vertex> vertices_;
    std::vector<std::pair<std::pair<int, int>, TopoDS_Edge>> edges_;
};

/// A pyramid whose tip was pulled through its base: its sides cross the base.
TopoDS_Shape pulledThrough()
{
    Polyhedron corners({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {3.0, 3.0, -1.0}, {1, 1, 1}});
    std::vector<TopoDS_Shape> faces = {corners.face({3, 2, 1, 0})};
    // The roof between the corners and (1, 1, 1), but that of the corner (2, 2, 0) leads to a point outside and below.
    faces.push_back(corners.face({0, 1, 5}));
    faces.push_back(corners.face({3, 0, 5}));
    faces.push_back(corners.face({1, 2, 4}));
    faces.push_back(corners.face({1, 4, 5}));
    faces.push_back(corners.face({2, 3, 4}));
    faces.push_back(corners.face({4, 3, 5}));
    return solidOf(shellOf(faces));
}

/// A box whose lid lies in its floor.
TopoDS_Shape withoutHeight()
{
    Polyhedron corners({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}});
    const TopoDS_Shape floor = corners.face({3, 2, 1, 0});
    const TopoDS_Shape lid = corners.face({0, 1, 2, 3});
    return solidOf(shellOf({floor, lid}));
}

/// A prism of a polygon that crosses itself.
TopoDS_Shape bowTiePrism()
{
    BRepBuilderAPI_MakePolygon polygon({0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, true);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire(), true).Face(), gp_Vec(0, 0, 1))
        .Shape();
}

/// Parts whose points have sines and cosines in their coordinates, as they are made and turned, in three units.
std::vector<std::pair<std::string, TopoDS_Shape>> roundParts()
{
    constexpr double kPi = std::numbers::pi;
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(16.0, 20.0).Shape();
    const std::vector<TopoDS_Shape> parts = {
        cylinder,
        BRepAlgoAPI_Cut(cylinder, BRepPrimAPI_MakeCylinder(9.0, 20.0).Shape()).Shape(),
        BRepAlgoAPI_Cut(box({-20, -15, 0}, {20, 15, 6}), BRepPrimAPI_MakeCylinder(8.0, 6.0).Shape()).Shape(),
        BRepPrimAPI_MakeTorus(30.0, 8.0, 0.5 * kPi).Shape(),
        BRepPrimAPI_MakeCylinder(16.0, 20.0, kPi).Shape(),
        BRepPrimAPI_MakeCone(16.0, 7.0, 18.0, 1.5 * kPi).Shape(),
        BRepPrimAPI_MakeSphere(gp_Pnt(), 16.0, 0.0, 0.5 * kPi).Shape(),
    };
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(3.0, -2.0, 5.0), gp_Dir(1.0, 2.0, 3.0)), 0.64);
    const std::vector<double> units = {1.0, 1.0 / 25.4, 1000.0};
    std::vector<std::pair<std::string, TopoDS_Shape>> all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const TopoDS_Shape turned = BRepBuilderAPI_Transform(parts[i], turn, true).Shape();
        all.emplace_back("round_" + std::to_string(i), parts[i]);
        all.emplace_back("round_turned_" + std::to_string(i), scaled(turned, units[i % units.size()]));
    }
    return all;
}

/// A prism of a triangle with an angle of 10 degrees, so that its floor and lid have one.
TopoDS_Shape needlePrism()
{
    BRepBuilderAPI_MakePolygon polygon({0, 0, 0}, {4, 0, 0}, {4, 0.7053, 0}, true);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire(), true).Face(), gp_Vec(0, 0, 1))
        .Shape();
}

bool writeText(const TopoDS_Shape& shape, const std::string& path)
{
    return !shape.IsNull() && BRepTools::Write(shape, path.c_str());
}

/// In the other formats that are read.
bool writeOthers(const TopoDS_Shape& shape, const std::string& path)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Writer step;
    IGESControl_Writer iges("MM", 0);
    return step.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
           step.Write((path + ".step").c_str()) == IFSelect_RetDone && iges.AddShape(shape) &&
           iges.Write((path + ".igs").c_str()) && BinTools::Write(shape, (path + ".bin.brep").c_str());
}

}  // namespace

int main(int count, char** words)
{
    if (count != 2) {
        std::fputs("usage: solid_models FOLDER\n", stderr);
        return 2;
    }
    const TopoDS_Shape unit = box({0, 0, 0}, {1, 1, 1});
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(0.5).Shape();
    std::vector<std::pair<std::string, TopoDS_Shape>> models = {
        {"box_with_hole", boxWithHole()},
        {"cut_ball", cutBall()},
        {"loft", loft()},
        {"glued_boxes", glued({unit, box({1, 0, 0}, {3, 1, 1})})},
        {"tiny_box", scaled(box({0, 0, 0}, {1, 2, 3}), 1e-3)},
        {"huge_box", scaled(box({0, 0, 0}, {1, 2, 3}), 1e4)},
        {"without_lid", withoutLid()},
        {"shell_only", shellOnly()},
        {"pulled_through", pulledThrough()},
        {"bow_tie_prism", bowTiePrism()},
        {"needle_prism", needlePrism()},
        {"without_height", withoutHeight()},
        {"thin_plate", box({0, 0, 0}, {10, 10, 0.001})},
        {"absurdly_small", box({0, 0, 0}, {1e-6, 1e-6, 1e-6})},
        {"absurdly_large", box({0, 0, 0}, {1e60, 1e60, 1e60})},
        // Solids that have nothing in common but lie in one another
        {"crossing_boxes", together({unit, moved(unit, 0.5, 0.4, 0.3)})},
        {"same_box_twice", together({unit, moved(unit, 0, 0, 0)})},
        {"ball_in_box", together({unit, moved(scaled(ball, 0.5), 0.5, 0.5, 0.5)})},
        {"box_in_box_on_floor", together({unit, box({0.25, 0.25, 0}, {0.75, 0.75, 0.5})})},
        {"bar_through_box", together({unit, box({-1, 0.4, 0.4}, {2, 0.6, 0.6})})},
        // … or touch
        {"boxes_face_to_face", together({unit, moved(unit, 1, 0, 0)})},
        {"small_box_on_box", together({unit, box({0.25, 0.25, 1}, {0.75, 0.75, 1.5})})},
        {"boxes_edge_to_edge", together({unit, moved(unit, 1, 1, 0)})},
        {"boxes_corner_to_corner", together({unit, moved(unit, 1, 1, 1)})},
        {"ball_on_box", together({unit, moved(ball, 0.5, 0.5, 1.5)})},
        {"pin_in_bore",
         together({boxWithHole(),
                   BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2.0, 1.5, 0.0), gp_Dir(0.0, 0.0, 1.0)), 0.7, 2.0)
                       .Shape()})},
        // Faces that are no solid yet, and what is no part of one
        {"box_of_faces", together(apart(facesOf(box({0, 0, 0}, {1, 2, 3}))))},
        {"open_box_of_faces", openBoxOfFaces()},
        {"box_with_lid_in_halves", boxWithLidInHalves()},
        {"hollow_of_faces", hollowOfFaces()},
        {"box_with_inner_face", boxWithInnerFace()},
        {"box_with_strays", boxWithStrays()},
        {"box_and_empty_solid", together({unit, emptySolid()})},
        {"empty_solid", emptySolid()},
        // … or are apart
        {"boxes_apart", together({unit, moved(unit, 1.5, 0, 0)})},
        {"pin_loose_in_bore",
         together({boxWithHole(),
                   BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2.0, 1.5, 0.0), gp_Dir(0.0, 0.0, 1.0)), 0.6, 2.0)
                       .Shape()})},
    };
    for (auto& part : roundParts()) models.push_back(std::move(part));
    for (const auto& [name, shape] : models) {
        const std::string path = std::string(words[1]) + '/' + name;
        const bool hasOthers = name == "box_with_hole" || name == "cut_ball";
        if (!writeText(shape, path + ".brep") || (hasOthers && !writeOthers(shape, path))) {
            std::fprintf(stderr, "solid_models: %s cannot be written\n", path.c_str());
            return 1;
        }
    }
    return 0;
}
