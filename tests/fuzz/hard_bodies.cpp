#include "hard_bodies.h"

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace mesher::test {

namespace {

constexpr double kPi = std::numbers::pi;

gp_Pnt inFrame(const gp_Ax2& frame, double x, double y, double z)
{
    return frame.Location().Translated(gp_Vec(frame.XDirection()) * x + gp_Vec(frame.YDirection()) * y +
                                       gp_Vec(frame.Direction()) * z);
}

TopoDS_Edge splineThrough(const std::vector<gp_Pnt>& places, bool isClosed)
{
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, static_cast<int>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) points->SetValue(static_cast<int>(i) + 1, places[i]);
    GeomAPI_Interpolate interpolate(points, isClosed, 1e-9);
    interpolate.Perform();
    return BRepBuilderAPI_MakeEdge(interpolate.Curve()).Edge();
}

/// A slot: two straight sides and two half circles.
TopoDS_Wire slotOf(const gp_Ax2& frame, double half, double radius)
{
    const std::array<gp_Pnt, 4> corners = {inFrame(frame, -half, -radius, 0),
                                           inFrame(frame, half, -radius, 0), inFrame(frame, half, radius, 0),
                                           inFrame(frame, -half, radius, 0)};
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(corners[0], corners[1]).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(
                 GC_MakeArcOfCircle(corners[1], inFrame(frame, half + radius, 0, 0), corners[2]).Value())
                 .Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(corners[2], corners[3]).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(
                 GC_MakeArcOfCircle(corners[3], inFrame(frame, -half - radius, 0, 0), corners[0]).Value())
                 .Edge());
    return wire.Wire();
}

/// A polygon star-shaped about the origin, with some of its sides bulged to arcs.
TopoDS_Wire bulgedPolygon(Draws& draws, const gp_Ax2& frame, double size)
{
    const std::uint32_t count = 3 + draws.below(5);
    std::vector<gp_Pnt> corners;
    std::vector<std::array<double, 2>> flat;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double turn = 2.0 * kPi * i / count, radius = draws.between(0.3, 0.55) * size;
        flat.push_back({radius * std::cos(turn), radius * std::sin(turn)});
        corners.push_back(inFrame(frame, flat.back()[0], flat.back()[1], 0.0));
    }
    BRepBuilderAPI_MakeWire wire;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t j = (i + 1) % count;
        if (draws.below(3) != 0) {
            wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[j]).Edge());
            continue;
        }
        const double bulge = draws.between(0.03, 0.3), dx = flat[j][0] - flat[i][0],
                     dy = flat[j][1] - flat[i][1];
        const gp_Pnt top = inFrame(frame, 0.5 * (flat[i][0] + flat[j][0]) + bulge * dy,
                                   0.5 * (flat[i][1] + flat[j][1]) - bulge * dx, 0.0);
        wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(corners[i], top, corners[j]).Value()).Edge());
    }
    return wire.Wire();
}

TopoDS_Wire closedSpline(Draws& draws, const gp_Ax2& frame, double size)
{
    std::vector<gp_Pnt> places;
    const std::uint32_t count = 5 + draws.below(6);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double turn = 2.0 * kPi * i / count, radius = draws.between(0.35, 0.55) * size;
        places.push_back(inFrame(frame, radius * std::cos(turn), radius * std::sin(turn), 0.0));
    }
    return BRepBuilderAPI_MakeWire(splineThrough(places, true)).Wire();
}

TopoDS_Wire section(Draws& draws, const gp_Ax2& frame, double size)
{
    switch (draws.below(5)) {
        case 0: {
            const gp_Circ circle(frame, draws.between(0.25, 0.5) * size);
            return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
        }
        case 1: return slotOf(frame, draws.between(0.1, 0.35) * size, draws.between(0.05, 0.2) * size);
        case 2: return closedSpline(draws, frame, size);
        case 3: {
            const double major = draws.between(0.3, 0.5) * size;
            const gp_Elips ellipse(frame, major, draws.between(0.1, 0.95) * major);
            return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse).Edge()).Wire();
        }
        default: return bulgedPolygon(draws, frame, size);
    }
}

TopoDS_Shape pad(Draws& draws, const gp_Ax2& frame, double size)
{
    const TopoDS_Wire outline = section(draws, frame, size);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline, true).Face(),
                                 gp_Vec(frame.Direction()) * draws.between(0.1, 0.8) * size)
        .Shape();
}

TopoDS_Shape draftedPad(Draws& draws, const gp_Ax2& frame, double size)
{
    const TopoDS_Shape body = pad(draws, frame, size);
    const double angle = draws.between(0.2, 12.0) * kPi / 180.0 * (draws.below(2) == 0 ? 1.0 : -1.0);
    BRepOffsetAPI_DraftAngle draft(body);
    for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next()) {
        const Handle(Geom_Plane) plane =
            Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(face.Current())));
        if (!plane.IsNull() && plane->Axis().Direction().IsParallel(frame.Direction(), 1e-6)) continue;
        draft.Add(TopoDS::Face(face.Current()), frame.Direction(), angle,
                  gp_Pln(frame.Location(), frame.Direction()));
        if (!draft.AddDone()) draft.Remove(TopoDS::Face(face.Current()));
    }
    draft.Build();
    return draft.Shape();
}

/// Along a spline, with the section kept at right angles to it.
TopoDS_Shape sweep(Draws& draws, const gp_Ax2& frame, double size)
{
    std::vector<gp_Pnt> places;
    const std::uint32_t count = 3 + draws.below(3);
    for (std::uint32_t i = 0; i < count; ++i)
        places.push_back(inFrame(frame, i == 0 ? 0.0 : draws.between(-0.25, 0.25) * size,
                                 i == 0 ? 0.0 : draws.between(-0.25, 0.25) * size, size * i / (count - 1.0)));
    const TopoDS_Edge spine = splineThrough(places, false);
    double first = 0.0, last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(spine, first, last);
    gp_Pnt start;
    gp_Vec tangent;
    curve->D1(first, start, tangent);
    const gp_Ax2 across(start, gp_Dir(tangent));
    const TopoDS_Wire outline = section(draws, across, draws.between(0.15, 0.35) * size);
    return BRepOffsetAPI_MakePipe(BRepBuilderAPI_MakeWire(spine).Wire(),
                                  BRepBuilderAPI_MakeFace(outline, true).Face())
        .Shape();
}

/// A coil: a section along a helix.
TopoDS_Shape coil(Draws& draws, const gp_Ax2& frame, double size)
{
    const double radius = draws.between(0.25, 0.5) * size, pitch = draws.between(0.1, 0.4) * size;
    const double turns = draws.between(0.3, 3.0);
    const Handle(Geom_CylindricalSurface) around = new Geom_CylindricalSurface(gp_Ax3(frame), radius);
    const double rise = std::hypot(2.0 * kPi, pitch);
    const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(2.0 * kPi, pitch));
    const TopoDS_Edge helix = BRepBuilderAPI_MakeEdge(line, around, 0.0, turns * rise).Edge();
    BRepLib::BuildCurves3d(helix);
    const gp_Ax2 across(inFrame(frame, radius, 0, 0), frame.YDirection(), frame.XDirection());
    BRepOffsetAPI_MakePipeShell pipe(BRepBuilderAPI_MakeWire(helix).Wire());
    pipe.SetMode(frame.Direction());
    pipe.Add(section(draws, across, 0.7 * pitch));
    pipe.Build();
    pipe.MakeSolid();
    return pipe.Shape();
}

TopoDS_Shape unlikeLoft(Draws& draws, const gp_Ax2& frame, double size)
{
    BRepOffsetAPI_ThruSections loft(true, draws.below(3) == 0, 1e-7);
    const std::uint32_t sections = 2 + draws.below(3);
    for (std::uint32_t i = 0; i < sections; ++i) {
        gp_Ax2 at(inFrame(frame, draws.between(-0.15, 0.15) * size, draws.between(-0.15, 0.15) * size,
                          size * i / (sections - 1.0)),
                  frame.Direction(), frame.XDirection());
        at.Rotate(gp_Ax1(at.Location(), at.XDirection()), draws.between(-0.25, 0.25));
        loft.AddWire(section(draws, at, draws.between(0.4, 1.0) * size));
    }
    return loft.Shape();
}

/// A profile that begins and ends on the axis, turned wholly or in part.
TopoDS_Shape turned(Draws& draws, const gp_Ax2& frame, double size)
{
    const double height = draws.between(0.3, 1.0) * size;
    std::vector<gp_Pnt> places = {frame.Location()};
    const std::uint32_t count = 2 + draws.below(3);
    for (std::uint32_t i = 1; i <= count; ++i)
        places.push_back(inFrame(frame, draws.between(0.15, 0.5) * size, 0.0, height * i / (count + 1.0)));
    places.push_back(inFrame(frame, 0.0, 0.0, height));
    BRepBuilderAPI_MakeWire wire;
    if (draws.below(2) == 0) {
        wire.Add(splineThrough(places, false));
    } else {
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
            wire.Add(BRepBuilderAPI_MakeEdge(places[i], places[i + 1]).Edge());
    }
    wire.Add(BRepBuilderAPI_MakeEdge(places.back(), places.front()).Edge());
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
    const gp_Ax1 axis(frame.Location(), frame.Direction());
    if (draws.below(2) == 0) return BRepPrimAPI_MakeRevol(face, axis).Shape();
    return BRepPrimAPI_MakeRevol(face, axis, draws.angle(0.3, 6.0)).Shape();
}

/// Another body with one direction stretched or pressed, which makes all its surfaces splines.
TopoDS_Shape stretched(Draws& draws, const gp_Ax2& frame, double size)
{
    const NamedShape body = draws.below(2) == 0 ? randomPrimitive(draws, frame.Location(), size)
                                                : NamedShape{pad(draws, frame, size), "pad"};
    gp_GTrsf stretch;
    stretch.SetAffinity(frame, draws.between(0.15, 3.0));
    return BRepBuilderAPI_GTransform(body.shape, stretch, true).Shape();
}

}  // namespace

NamedShape hardBody(Draws& draws, const gp_Pnt& place, double size)
{
    using Make = TopoDS_Shape (*)(Draws&, const gp_Ax2&, double);
    struct Kind
    {
        const char* name;
        Make make;
    };
    constexpr std::array<Kind, 9> kKinds = {{{"pad", pad},
                                             {"drafted", draftedPad},
                                             {"drafted", draftedPad},
                                             {"sweep", sweep},
                                             {"coil", coil},
                                             {"unlike-loft", unlikeLoft},
                                             {"turned", turned},
                                             {"turned", turned},
                                             {"stretched", stretched}}};
    const Kind& kind = kKinds[draws.below(kKinds.size())];
    const gp_Ax2 frame(place, draws.direction());
    return {kind.make(draws, frame, size), kind.name};
}

}  // namespace mesher::test
