#include "random_solids.h"

#include "random_primitives.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <numbers>

namespace mesher::test {

namespace {

constexpr double kSize = 10.0;  // of the first primitive, before the scale
constexpr std::uint32_t kMostSteps = 5;

struct Corners
{
    gp_Pnt low;
    gp_Pnt high;
    [[nodiscard]] double diagonal() const { return low.Distance(high); }
};

Corners cornersOf(const TopoDS_Shape& shape)
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

double volumeOf(const TopoDS_Shape& shape)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

/// The solids of a result without the compound around a single one.
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
    return volumeOf(shape) > 0.0 && BRepCheck_Analyzer(shape).IsValid();
}

NamedShape combined(Draws& draws, const TopoDS_Shape& body)
{
    const Corners corners = cornersOf(body);
    const double size = draws.between(0.2, 0.8) * corners.diagonal() / std::numbers::sqrt3;
    const NamedShape tool = randomPrimitive(draws, draws.point(corners.low, corners.high), size);
    switch (draws.below(5)) {
        case 0:
        case 1: return {BRepAlgoAPI_Fuse(body, tool.shape).Shape(), "fuse-" + tool.name};
        case 2: return {BRepAlgoAPI_Common(body, tool.shape).Shape(), "common-" + tool.name};
        default: return {BRepAlgoAPI_Cut(body, tool.shape).Shape(), "cut-" + tool.name};
    }
}

/// Equal holes on a circle or in a row.
NamedShape drilled(Draws& draws, const TopoDS_Shape& body)
{
    const Corners corners = cornersOf(body);
    const gp_Pnt centre = draws.point(corners.low, corners.high);
    const gp_Dir axis = draws.direction();
    const gp_Ax2 frame(centre, axis);
    const double length = 2.0 * corners.diagonal();
    const double radius = draws.between(0.01, 0.06) * corners.diagonal();
    const double spacing = draws.between(2.2, 5.0) * radius;
    const std::uint32_t holes = 1 + draws.below(5);
    const bool isRound = draws.below(2) == 0;
    TopTools_ListOfShape tools;
    for (std::uint32_t i = 0; i < holes; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / holes;
        const gp_Vec shift = isRound ? gp_Vec(frame.XDirection()) * spacing * std::cos(turn) +
                                           gp_Vec(frame.YDirection()) * spacing * std::sin(turn)
                                     : gp_Vec(frame.XDirection()) * spacing * i;
        const gp_Pnt start = centre.Translated(shift - gp_Vec(axis) * 0.5 * length);
        tools.Append(BRepPrimAPI_MakeCylinder(gp_Ax2(start, axis), radius, length).Shape());
    }
    TopTools_ListOfShape bodies;
    bodies.Append(body);
    BRepAlgoAPI_Cut cut;
    cut.SetArguments(bodies);
    cut.SetTools(tools);
    cut.Build();
    return {cut.Shape(), "drill" + std::to_string(holes)};
}

/// Some edges, or all, rounded or cut off by one measure.
NamedShape softened(Draws& draws, const TopoDS_Shape& body)
{
    const double measure = draws.between(0.005, 0.06) * cornersOf(body).diagonal();
    const std::uint32_t share = draws.below(3) == 0 ? 1 : 2 + draws.below(6);
    const TopTools_IndexedMapOfShape edges = partsOf(body, TopAbs_EDGE);
    BRepFilletAPI_MakeFillet fillet(body);
    BRepFilletAPI_MakeChamfer chamfer(body);
    const bool isRound = draws.below(3) != 0;
    for (int i = 1; i <= edges.Extent(); ++i) {
        if (draws.below(share) != 0) continue;
        if (isRound) {
            fillet.Add(measure, TopoDS::Edge(edges(i)));
        } else {
            chamfer.Add(measure, TopoDS::Edge(edges(i)));
        }
    }
    return isRound ? NamedShape{fillet.Shape(), "fillet"} : NamedShape{chamfer.Shape(), "chamfer"};
}

NamedShape hollowed(Draws& draws, const TopoDS_Shape& body)
{
    const TopTools_IndexedMapOfShape faces = partsOf(body, TopAbs_FACE);
    TopTools_ListOfShape open;
    open.Append(faces(1 + static_cast<int>(draws.below(static_cast<std::uint32_t>(faces.Extent())))));
    const double wall = draws.between(0.01, 0.05) * cornersOf(body).diagonal();
    BRepOffsetAPI_MakeThickSolid thick;
    thick.MakeThickSolidByJoin(body, open, -wall, 1e-5);
    return {thick.Shape(), "hollow"};
}

/// Two solids or more that share the faces between them.
NamedShape split(Draws& draws, const TopoDS_Shape& body)
{
    const Corners corners = cornersOf(body);
    const gp_Pln plane(draws.point(corners.low, corners.high), draws.direction());
    const double half = corners.diagonal();
    TopTools_ListOfShape bodies, tools;
    bodies.Append(body);
    tools.Append(BRepBuilderAPI_MakeFace(plane, -half, half, -half, half).Face());
    BRepAlgoAPI_Splitter splitter;
    splitter.SetArguments(bodies);
    splitter.SetTools(tools);
    splitter.Build();
    return {solidsOf(splitter.Shape()), "split"};
}

NamedShape changed(Draws& draws, const TopoDS_Shape& body)
{
    switch (draws.below(10)) {
        case 0:
        case 1: return drilled(draws, body);
        case 2:
        case 3:
        case 4: return softened(draws, body);
        case 5: return hollowed(draws, body);
        case 6: return split(draws, body);
        default: return combined(draws, body);
    }
}

/// Some edges rounded by a radius that changes along them.
NamedShape roundedUnevenly(Draws& draws, const TopoDS_Shape& body)
{
    const double size = cornersOf(body).diagonal();
    const TopTools_IndexedMapOfShape edges = partsOf(body, TopAbs_EDGE);
    BRepFilletAPI_MakeFillet fillet(body);
    for (int i = 1; i <= edges.Extent(); ++i) {
        if (draws.below(4) == 0)
            fillet.Add(draws.between(0.005, 0.05) * size, draws.between(0.005, 0.05) * size,
                       TopoDS::Edge(edges(i)));
    }
    return {fillet.Shape(), "uneven-fillet"};
}

/// Some edges cut off by two distances.
NamedShape cutOffUnevenly(Draws& draws, const TopoDS_Shape& body)
{
    const double size = cornersOf(body).diagonal();
    TopTools_IndexedDataMapOfShapeListOfShape faces;
    TopExp::MapShapesAndAncestors(body, TopAbs_EDGE, TopAbs_FACE, faces);
    BRepFilletAPI_MakeChamfer chamfer(body);
    for (int i = 1; i <= faces.Extent(); ++i) {
        if (draws.below(4) == 0)
            chamfer.Add(draws.between(0.005, 0.05) * size, draws.between(0.005, 0.05) * size,
                        TopoDS::Edge(faces.FindKey(i)), TopoDS::Face(faces(i).First()));
    }
    return {chamfer.Shape(), "uneven-chamfer"};
}

/// A second solid of its own, as high as the body, which touches the body's box or stands beside it.
NamedShape accompanied(Draws& draws, const TopoDS_Shape& body)
{
    const Corners corners = cornersOf(body);
    const double gap = draws.below(2) == 0 ? 0.0 : draws.between(0.001, 0.5) * corners.diagonal();
    const gp_Pnt low(corners.high.X() + gap, corners.low.Y(), corners.low.Z());
    const gp_Pnt high(low.X() + draws.between(0.1, 0.5) * corners.diagonal(), corners.high.Y(),
                      corners.high.Z());
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, body);
    builder.Add(both, BRepPrimAPI_MakeBox(low, high).Shape());
    return {both, gap > 0.0 ? "beside" : "touching"};
}

NamedShape changedWidely(Draws& draws, const TopoDS_Shape& body)
{
    switch (draws.below(9)) {
        case 0: return roundedUnevenly(draws, body);
        case 1: return cutOffUnevenly(draws, body);
        case 2: return accompanied(draws, body);
        default: return changed(draws, body);
    }
}

/// Takes the step if the kernel can do it and finds the result valid.
void step(std::uint64_t seed, bool snaps, bool isWide, RandomSolid& solid)
{
    Draws draws(seed, snaps);
    NamedShape made;
    try {
        made = isWide ? changedWidely(draws, solid.shape) : changed(draws, solid.shape);
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

gp_Trsf placement(Draws& draws)
{
    gp_Trsf turn, shift, scale;
    if (draws.below(2) == 0) {
        turn.SetRotation(gp_Ax1(gp_Pnt(), draws.direction()), draws.between(0.0, 6.0));
        const double far = draws.below(4) == 0 ? 1000.0 : 20.0;
        shift.SetTranslation(
            gp_Vec(draws.between(-far, far), draws.between(-far, far), draws.between(-far, far)));
    }
    const double factor = draws.below(2) == 0 ? 1.0 : std::pow(10.0, draws.between(-4.0, 3.0));
    scale.SetScale(gp_Pnt(), factor);
    return scale * shift * turn;
}

std::uint64_t seedOf(std::uint64_t seed, std::uint64_t part)
{
    return Random(seed * 0xD1342543DE82EF95u + part)();
}

}  // namespace

RandomSolid randomSolid(std::uint64_t seed, std::uint32_t mask, bool isWide)
{
    RandomSolid solid;
    Draws first(seedOf(seed, 0), Random(seedOf(seed, 1)).below(2) == 0);
    const bool snaps = first.snaps();
    solid.steps = first.below(kMostSteps + 1);
    try {
        const NamedShape primitive = randomPrimitive(first, gp_Pnt(), kSize);
        solid.recipe = primitive.name;
        if (isUsable(primitive.shape)) solid.shape = primitive.shape;
    } catch (const Standard_Failure&) {
        solid.recipe = "(failed)";
    }
    if (solid.shape.IsNull()) return solid;
    for (std::uint32_t i = 0; i < solid.steps; ++i) {
        if ((mask >> i & 1u) != 0) step(seedOf(seed, 10 + i), snaps, isWide, solid);
    }
    Draws last(seedOf(seed, 2), false);
    const gp_Trsf place = placement(last);
    solid.shape = BRepBuilderAPI_Transform(solid.shape, place, true).Shape();
    if (isWide && last.below(5) == 0) {
        gp_Trsf away;
        away.SetTranslation(gp_Vec(last.direction()) * 1e5 * cornersOf(solid.shape).diagonal());
        solid.shape = BRepBuilderAPI_Transform(solid.shape, away, true).Shape();
        solid.recipe += " far";
    }
    if (place.ScaleFactor() != 1.0) solid.recipe += " x" + std::to_string(place.ScaleFactor());
    return solid;
}

}  // namespace mesher::test
