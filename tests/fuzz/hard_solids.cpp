#include "hard_solids.h"

#include "hard_bodies.h"
#include "random_primitives.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>

#include <array>
#include <cmath>
#include <exception>
#include <numbers>

namespace mesher::test {

namespace {

constexpr double kSize = 10.0;
constexpr std::uint32_t kMostSteps = 4;

struct Extent
{
    gp_Pnt low;
    gp_Pnt high;
    [[nodiscard]] double diagonal() const { return low.Distance(high); }
};

Extent extentOf(const TopoDS_Shape& shape)
{
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    return {box.CornerMin(), box.CornerMax()};
}

TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, kind, parts);
    return parts;
}

TopoDS_Shape solidsOf(const TopoDS_Shape& shape)
{
    const TopTools_IndexedMapOfShape solids = partsOf(shape, TopAbs_SOLID);
    if (solids.Extent() == 1) return solids(1);
    TopoDS_Compound compound;
    const BRep_Builder builder;
    builder.MakeCompound(compound);
    for (int i = 1; i <= solids.Extent(); ++i) builder.Add(compound, solids(i));
    return compound;
}

bool isUsable(const TopoDS_Shape& shape)
{
    if (shape.IsNull() || partsOf(shape, TopAbs_SOLID).Extent() == 0) return false;
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass() > 0.0 && BRepCheck_Analyzer(shape).IsValid();
}

TopoDS_Shape joined(Draws& draws, const TopoDS_Shape& body, const TopoDS_Shape& tool)
{
    return draws.below(2) == 0 ? BRepAlgoAPI_Fuse(body, tool).Shape() : BRepAlgoAPI_Cut(body, tool).Shape();
}

NamedShape varyingFillet(Draws& draws, const TopoDS_Shape& body)
{
    const double size = extentOf(body).diagonal();
    const TopTools_IndexedMapOfShape edges = partsOf(body, TopAbs_EDGE);
    const std::uint32_t share = 1 + draws.below(5);
    const double radius = draws.between(0.002, 0.05) * size;
    BRepFilletAPI_MakeFillet fillet(body);
    for (int i = 1; i <= edges.Extent(); ++i) {
        if (draws.below(share) != 0) continue;
        if (draws.below(2) == 0) {
            fillet.Add(radius, TopoDS::Edge(edges(i)));
        } else {
            fillet.Add(draws.between(0.3, 1.0) * radius, radius, TopoDS::Edge(edges(i)));
        }
    }
    return {fillet.Shape(), "fillet"};
}

NamedShape thickened(Draws& draws, const TopoDS_Shape& body)
{
    const TopTools_IndexedMapOfShape faces = partsOf(body, TopAbs_FACE);
    TopTools_ListOfShape open;
    open.Append(faces(1 + static_cast<int>(draws.below(static_cast<std::uint32_t>(faces.Extent())))));
    const double wall = draws.between(0.003, 0.05) * extentOf(body).diagonal();
    BRepOffsetAPI_MakeThickSolid thick;
    thick.MakeThickSolidByJoin(body, open, draws.below(3) == 0 ? wall : -wall, 1e-4);
    return {thick.Shape(), "thick"};
}

/// A ridge along a helix, as for a thread.
TopoDS_Shape ridge(const gp_Ax2& frame, double radius, double pitch, double turns)
{
    const Handle(Geom_CylindricalSurface) around = new Geom_CylindricalSurface(gp_Ax3(frame), radius);
    const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(2.0 * std::numbers::pi, pitch));
    const TopoDS_Edge helix =
        BRepBuilderAPI_MakeEdge(line, around, 0.0, turns * std::hypot(2.0 * std::numbers::pi, pitch)).Edge();
    BRepLib::BuildCurves3d(helix);
    const auto at = [&](double out, double up) {
        return frame.Location().Translated(gp_Vec(frame.XDirection()) * (radius + out) +
                                           gp_Vec(frame.Direction()) * up);
    };
    BRepBuilderAPI_MakePolygon profile(at(-0.2 * pitch, -0.35 * pitch), at(-0.2 * pitch, 0.35 * pitch),
                                       at(0.4 * pitch, 0.0), true);
    BRepOffsetAPI_MakePipeShell pipe(BRepBuilderAPI_MakeWire(helix).Wire());
    pipe.SetMode(frame.Direction());
    pipe.Add(profile.Wire());
    pipe.Build();
    pipe.MakeSolid();
    return pipe.Shape();
}

NamedShape threaded(Draws& draws, const TopoDS_Shape& body)
{
    const Extent extent = extentOf(body);
    const double size = extent.diagonal();
    const gp_Ax2 frame(draws.point(extent.low, extent.high), draws.direction());
    const double radius = draws.between(0.08, 0.25) * size, pitch = draws.between(0.15, 0.5) * radius;
    const double turns = draws.between(1.0, 5.0);
    const TopoDS_Shape core = BRepPrimAPI_MakeCylinder(frame.Translated(gp_Vec(frame.Direction()) * -pitch),
                                                       radius, (turns + 2.0) * pitch)
                                  .Shape();
    const TopoDS_Shape bolt = joined(draws, core, ridge(frame, radius, pitch, turns));
    return {joined(draws, body, bolt), "thread"};
}

NamedShape tinyHoles(Draws& draws, const TopoDS_Shape& body)
{
    const Extent extent = extentOf(body);
    const double size = extent.diagonal();
    TopTools_ListOfShape bodies, tools;
    bodies.Append(body);
    const std::uint32_t holes = 1 + draws.below(3);
    for (std::uint32_t i = 0; i < holes; ++i) {
        const gp_Pnt middle = draws.point(extent.low, extent.high);
        const gp_Dir axis = draws.direction();
        const double radius = size * std::pow(10.0, draws.between(-3.5, -1.5));
        const double length = draws.below(2) == 0 ? 2.0 * size : draws.between(2.0, 30.0) * radius;
        tools.Append(BRepPrimAPI_MakeCylinder(gp_Ax2(middle.Translated(gp_Vec(axis) * -0.5 * length), axis),
                                              radius, length)
                         .Shape());
    }
    BRepAlgoAPI_Cut cut;
    cut.SetArguments(bodies);
    cut.SetTools(tools);
    cut.Build();
    return {cut.Shape(), "tiny-holes"};
}

/// With a copy of itself, or a box over its box, moved by nearly nothing.
NamedShape nearlyCoincident(Draws& draws, const TopoDS_Shape& body)
{
    const Extent extent = extentOf(body);
    const gp_Vec shift =
        gp_Vec(draws.direction()) * extent.diagonal() * std::pow(10.0, draws.between(-5.0, -1.5));
    gp_Trsf move;
    move.SetTranslation(shift);
    if (draws.below(2) == 0)
        return {joined(draws, body, BRepBuilderAPI_Transform(body, move, true).Shape()), "near-copy"};
    const gp_Vec diagonal(extent.low, extent.high);
    const gp_Pnt high = extent.low.Translated(diagonal * draws.between(0.4, 1.0));
    const TopoDS_Shape box =
        BRepPrimAPI_MakeBox(extent.low.Translated(shift), high.Translated(shift)).Shape();
    return {joined(draws, body, box), "near-box"};
}

NamedShape mirrored(Draws& draws, const TopoDS_Shape& body)
{
    const Extent extent = extentOf(body);
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(draws.point(extent.low, extent.high), draws.direction()));
    const TopoDS_Shape image = BRepBuilderAPI_Transform(body, mirror, true).Shape();
    if (draws.below(3) == 0) return {image, "mirror"};
    return {BRepAlgoAPI_Fuse(body, image).Shape(), "mirror-fuse"};
}

NamedShape combined(Draws& draws, const TopoDS_Shape& body)
{
    const Extent extent = extentOf(body);
    const double size = draws.between(0.2, 0.8) * extent.diagonal() / std::numbers::sqrt3;
    const gp_Pnt place = draws.point(extent.low, extent.high);
    const NamedShape tool =
        draws.below(2) == 0 ? hardBody(draws, place, size) : randomPrimitive(draws, place, size);
    return {joined(draws, body, tool.shape), "with-" + tool.name};
}

/// Curves of some edges moved off their faces by less than the tolerance that they get.
NamedShape loosened(Draws& draws, const TopoDS_Shape& body)
{
    TopoDS_Shape copy = BRepBuilderAPI_Copy(body).Shape();
    const double tolerance = extentOf(body).diagonal() * std::pow(10.0, draws.between(-5.0, -2.7));
    const BRep_Builder builder;
    const TopTools_IndexedMapOfShape edges = partsOf(copy, TopAbs_EDGE);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (BRep_Tool::Degenerated(edge) || draws.below(2) == 0) continue;
        TopLoc_Location location;
        double first = 0.0, last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
        if (curve.IsNull()) continue;
        const Handle(Geom_Curve) moved = Handle(Geom_Curve)::DownCast(
            curve->Translated(gp_Vec(draws.direction()) * draws.between(0.1, 0.9) * tolerance));
        builder.UpdateEdge(edge, moved, location, tolerance);
        for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
            builder.UpdateVertex(end, tolerance);
    }
    return {copy, "loose"};
}

NamedShape changed(Draws& draws, const TopoDS_Shape& body)
{
    using Change = NamedShape (*)(Draws&, const TopoDS_Shape&);
    constexpr std::array<Change, 12> kChanges = {varyingFillet,    varyingFillet, thickened, threaded,
                                                 tinyHoles,        tinyHoles,     mirrored,  combined,
                                                 nearlyCoincident, combined,      combined,  loosened};
    return kChanges[draws.below(kChanges.size())](draws, body);
}

void step(std::uint64_t seed, bool snaps, HardSolid& solid)
{
    Draws draws(seed, snaps);
    NamedShape made;
    try {
        made = changed(draws, solid.shape);
        if (!made.shape.IsNull()) made.shape = solidsOf(made.shape);
    } catch (const Standard_Failure&) {
        made.shape.Nullify();
    } catch (const std::exception&) {
        made.shape.Nullify();
    }
    const bool isTaken = isUsable(made.shape);
    solid.recipe += isTaken ? ' ' + made.name : " (" + (made.name.empty() ? "failed" : made.name) + ')';
    if (isTaken) solid.shape = made.shape;
}

void place(std::uint64_t seed, HardSolid& solid)
{
    Draws draws(seed, false);
    gp_Trsf turn, move, scale;
    turn.SetRotation(gp_Ax1(gp_Pnt(), draws.direction()),
                     draws.below(2) == 0 ? 0.0 : draws.between(0.0, 6.0));
    if (draws.below(4) == 0) {
        const double sizes = std::pow(10.0, draws.between(0.0, 5.0));
        move.SetTranslation(gp_Vec(draws.direction()) * sizes * kSize);
        solid.recipe += " far" + std::to_string(sizes);
    }
    if (draws.below(2) == 0) {
        const double factor = std::pow(10.0, draws.between(-6.0, 6.0));
        scale.SetScale(gp_Pnt(), factor);
        solid.recipe += " x" + std::to_string(factor);
    }
    solid.shape = BRepBuilderAPI_Transform(solid.shape, scale * move * turn, true).Shape();
}

std::uint64_t seedOf(std::uint64_t seed, std::uint64_t part)
{
    return Random(seed * 0xD1342543DE82EF95u + 7919u * part + 77u)();
}

}  // namespace

HardSolid hardSolid(std::uint64_t seed)
{
    HardSolid solid;
    Random random(seedOf(seed, 0));
    const bool snaps = random.below(2) == 0;
    const std::uint32_t steps = random.below(kMostSteps + 1);
    Draws draws(seedOf(seed, 1), snaps);
    try {
        const NamedShape body =
            draws.below(4) == 0 ? randomPrimitive(draws, gp_Pnt(), kSize) : hardBody(draws, gp_Pnt(), kSize);
        solid.recipe = body.name;
        if (isUsable(body.shape)) solid.shape = solidsOf(body.shape);
    } catch (const Standard_Failure&) {
        solid.recipe = "(failed)";
    }
    if (solid.shape.IsNull()) return solid;
    for (std::uint32_t i = 0; i < steps; ++i) step(seedOf(seed, 10 + i), snaps, solid);
    place(seedOf(seed, 2), solid);
    return solid;
}

}  // namespace mesher::test
