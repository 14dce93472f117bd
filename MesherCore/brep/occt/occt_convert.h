#pragma once

#include "base/vec.h"
#include "brep/analytic/axes.h"

#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

namespace mesher {

[[nodiscard]] inline Vec3 toVec(const gp_XYZ& p)
{
    return {p.X(), p.Y(), p.Z()};
}

[[nodiscard]] inline Vec3 toVec(const gp_Pnt& p)
{
    return toVec(p.XYZ());
}

[[nodiscard]] inline Vec3 toVec(const gp_Vec& v)
{
    return toVec(v.XYZ());
}

[[nodiscard]] inline Vec3 toVec(const gp_Dir& d)
{
    return toVec(d.XYZ());
}

[[nodiscard]] inline Vec2 toVec(const gp_Pnt2d& p)
{
    return {p.X(), p.Y()};
}

[[nodiscard]] inline gp_Pnt toPoint(const Vec3& p)
{
    return {p.x, p.y, p.z};
}

[[nodiscard]] inline Axes toAxes(const gp_Ax3& a)
{
    return {toVec(a.Location()), toVec(a.XDirection()), toVec(a.YDirection()), toVec(a.Direction())};
}

[[nodiscard]] inline Axes toAxes(const gp_Ax2& a)
{
    return {toVec(a.Location()), toVec(a.XDirection()), toVec(a.YDirection()), toVec(a.Direction())};
}

}  // namespace mesher
