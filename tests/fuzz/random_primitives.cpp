#include "random_primitives.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include <array>
#include <cmath>
#include <numbers>

namespace mesher::test {

namespace {

constexpr double kPi = std::numbers::pi;

/// The place at (x, y, z) of a frame.
gp_Pnt inFrame(const gp_Ax2& frame, double x, double y, double z)
{
    return frame.Location().Translated(gp_Vec(frame.XDirection()) * x + gp_Vec(frame.YDirection()) * y +
                                       gp_Vec(frame.Direction()) * z);
}

TopoDS_Wire circleOf(const gp_Ax2& frame, double radius)
{
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(frame, radius)).Edge()).Wire();
}

TopoDS_Wire polygonOf(Draws& draws, const gp_Ax2& frame, double size)
{
    const std::uint32_t corners = 3 + draws.below(6);
    BRepBuilderAPI_MakePolygon polygon;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double turn = 2.0 * kPi * i / corners;
        const double radius = draws.extent(0.25 * size, 0.6 * size);
        polygon.Add(inFrame(frame, radius * std::cos(turn), radius * std::sin(turn), 0.0));
    }
    polygon.Close();
    return polygon.Wire();
}

/// A closed spline, star-shaped about the frame's origin.
TopoDS_Wire splineOf(Draws& draws, const gp_Ax2& frame, double size)
{
    const int points = 6 + static_cast<int>(draws.below(8));
    const Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, points);
    for (int i = 0; i < points; ++i) {
        const double turn = 2.0 * kPi * i / points;
        const double radius = draws.between(0.35 * size, 0.6 * size);
        places->SetValue(i + 1, inFrame(frame, radius * std::cos(turn), radius * std::sin(turn), 0.0));
    }
    GeomAPI_Interpolate interpolate(places, true, 1e-9);
    interpolate.Perform();
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolate.Curve()).Edge()).Wire();
}

TopoDS_Wire profileOf(Draws& draws, const gp_Ax2& frame, double size)
{
    switch (draws.below(4)) {
        case 0: return circleOf(frame, draws.extent(0.2 * size, 0.5 * size));
        case 1: return splineOf(draws, frame, size);
        case 2: {
            const double major = draws.extent(0.4 * size, 0.6 * size);
            const gp_Elips ellipse(frame, major, draws.between(0.3, 0.9) * major);
            return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse).Edge()).Wire();
        }
        default: return polygonOf(draws, frame, size);
    }
}

TopoDS_Shape box(Draws& draws, const gp_Ax2& frame, double size)
{
    const double x = draws.extent(0.3 * size, size), y = draws.extent(0.3 * size, size);
    return BRepPrimAPI_MakeBox(frame, x, y, draws.extent(0.3 * size, size)).Shape();
}

TopoDS_Shape cylinder(Draws& draws, const gp_Ax2& frame, double size)
{
    const double radius = draws.extent(0.1 * size, 0.5 * size), height = draws.extent(0.3 * size, size);
    if (draws.below(4) != 0) return BRepPrimAPI_MakeCylinder(frame, radius, height).Shape();
    return BRepPrimAPI_MakeCylinder(frame, radius, height, draws.angle(0.5, 6.0)).Shape();
}

TopoDS_Shape cone(Draws& draws, const gp_Ax2& frame, double size)
{
    const double radius = draws.extent(0.2 * size, 0.5 * size), height = draws.extent(0.3 * size, size);
    const double top = draws.below(3) == 0 ? 0.0 : draws.between(0.2, 0.8) * radius;
    return BRepPrimAPI_MakeCone(frame, radius, top, height).Shape();
}

TopoDS_Shape sphere(Draws& draws, const gp_Ax2& frame, double size)
{
    const double radius = draws.extent(0.2 * size, 0.5 * size);
    if (draws.below(3) != 0) return BRepPrimAPI_MakeSphere(frame, radius).Shape();
    const double low = -draws.angle(0.2, 1.2), high = draws.angle(0.2, 1.2);
    return BRepPrimAPI_MakeSphere(frame, radius, low, high, draws.angle(1.0, 6.0)).Shape();
}

TopoDS_Shape torus(Draws& draws, const gp_Ax2& frame, double size)
{
    const double major = draws.extent(0.3 * size, 0.5 * size), minor = draws.between(0.15, 0.6) * major;
    if (draws.below(3) != 0) return BRepPrimAPI_MakeTorus(frame, major, minor).Shape();
    return BRepPrimAPI_MakeTorus(frame, major, minor, draws.angle(0.5, 6.0)).Shape();
}

TopoDS_Shape wedge(Draws& draws, const gp_Ax2& frame, double size)
{
    const double x = draws.extent(0.4 * size, size), y = draws.extent(0.3 * size, size);
    const double z = draws.extent(0.4 * size, size);
    return BRepPrimAPI_MakeWedge(frame, x, y, z, draws.between(0.0, 0.8) * x).Shape();
}

TopoDS_Shape prism(Draws& draws, const gp_Ax2& frame, double size)
{
    const TopoDS_Wire profile = profileOf(draws, frame, size);
    gp_Vec along = gp_Vec(frame.Direction()) * draws.extent(0.2 * size, size);
    if (draws.below(3) == 0) along += gp_Vec(frame.XDirection()) * draws.between(0.1, 0.4) * size;
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(profile, true).Face(), along).Shape();
}

/// About an axis beside the profile.
TopoDS_Shape revolved(Draws& draws, const gp_Ax2& frame, double size)
{
    const TopoDS_Wire profile = profileOf(draws, frame, 0.5 * size);
    const gp_Ax1 axis(inFrame(frame, -draws.between(0.35, 0.6) * size, 0.0, 0.0), frame.YDirection());
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(profile, true).Face();
    if (draws.below(2) == 0) return BRepPrimAPI_MakeRevol(face, axis).Shape();
    return BRepPrimAPI_MakeRevol(face, axis, draws.angle(0.6, 5.5)).Shape();
}

TopoDS_Shape loft(Draws& draws, const gp_Ax2& frame, double size)
{
    const bool isRuled = draws.below(3) == 0;
    BRepOffsetAPI_ThruSections loft(true, isRuled, 1e-7);
    const std::uint32_t sections = 2 + draws.below(3);
    const bool isRound = draws.below(2) == 0;
    for (std::uint32_t i = 0; i < sections; ++i) {
        const gp_Ax2 at(inFrame(frame, draws.between(-0.1, 0.1) * size, 0.0, 0.35 * size * i),
                        frame.Direction(), frame.XDirection());
        const double width = draws.extent(0.5 * size, size);
        loft.AddWire(isRound ? circleOf(at, 0.4 * width) : splineOf(draws, at, width));
    }
    return loft.Shape();
}

TopoDS_Shape pipe(Draws& draws, const gp_Ax2& frame, double size)
{
    const gp_Pnt start = frame.Location();
    const double bend = draws.between(0.2, 0.6) * size;
    const GC_MakeArcOfCircle arc(start, inFrame(frame, 0.3 * bend, 0.0, 0.7 * bend),
                                 inFrame(frame, bend, 0.0, bend));
    const TopoDS_Wire spine = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(arc.Value()).Edge()).Wire();
    const gp_Vec tangent = arc.Value()->DN(arc.Value()->FirstParameter(), 1);
    const gp_Ax2 across(start, gp_Dir(tangent), frame.YDirection());
    const TopoDS_Wire profile = profileOf(draws, across, draws.between(0.15, 0.35) * size);
    return BRepOffsetAPI_MakePipe(spine, BRepBuilderAPI_MakeFace(profile, true).Face()).Shape();
}

}  // namespace

double Draws::extent(double low, double high)
{
    const double value = random_.between(low, high);
    return snaps_ ? std::max(0.5, 0.5 * std::round(2.0 * value)) : value;
}

double Draws::angle(double low, double high)
{
    constexpr double kStep = kPi / 6.0;
    const double value = random_.between(low, high);
    return snaps_ ? std::max(1.0, std::round(value / kStep)) * kStep : value;
}

gp_Pnt Draws::point(const gp_Pnt& low, const gp_Pnt& high)
{
    const auto coordinate = [&](double a, double b) {
        const double value = random_.between(a, b);
        return snaps_ ? 0.5 * std::round(2.0 * value) : value;
    };
    const double x = coordinate(low.X(), high.X()), y = coordinate(low.Y(), high.Y());
    return {x, y, coordinate(low.Z(), high.Z())};
}

gp_Dir Draws::direction()
{
    if (snaps_) {
        const std::array<gp_Dir, 6> axes = {gp_Dir(0, 0, 1),  gp_Dir(1, 0, 0),  gp_Dir(0, 1, 0),
                                            gp_Dir(0, 0, -1), gp_Dir(-1, 0, 0), gp_Dir(0, -1, 0)};
        return axes[random_.below(6)];
    }
    const double z = random_.between(-1.0, 1.0), turn = random_.between(0.0, 2.0 * kPi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

NamedShape randomPrimitive(Draws& draws, const gp_Pnt& place, double size)
{
    using Make = TopoDS_Shape (*)(Draws&, const gp_Ax2&, double);
    struct Kind
    {
        const char* name;
        Make make;
    };
    // Plain ones are drawn more often, as in real parts.
    constexpr std::array<Kind, 15> kKinds = {{{"box", box},
                                              {"box", box},
                                              {"box", box},
                                              {"cylinder", cylinder},
                                              {"cylinder", cylinder},
                                              {"cylinder", cylinder},
                                              {"cone", cone},
                                              {"sphere", sphere},
                                              {"torus", torus},
                                              {"wedge", wedge},
                                              {"prism", prism},
                                              {"prism", prism},
                                              {"revolved", revolved},
                                              {"loft", loft},
                                              {"pipe", pipe}}};
    const Kind& kind = kKinds[draws.below(kKinds.size())];
    const gp_Ax2 frame(place, draws.direction());
    return {kind.make(draws, frame, size), kind.name};
}

}  // namespace mesher::test
