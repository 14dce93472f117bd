#pragma once

#include "predicates/fixed_integer.h"
#include "predicates/integer_grid.h"

#include <cstddef>

/// The determinants of the predicates on integer coordinates, exact.
///
/// With n limbs per coordinate, differences are below 2^(64n - 2) in magnitude. Then products of two, sums of
/// three of them and differences of two of them stay below 2^(128n - 2) and fit 2n limbs; a difference of two
/// products of a coordinate and a lift stays below 2^(192n - 3) (3n limbs); the six terms of the largest
/// determinant sum to less than 2^(320n - 3) (5n limbs).
namespace mesher::detail {

template <std::size_t Limbs>
struct GridVec2
{
    FixedInteger<Limbs> x;
    FixedInteger<Limbs> y;
};

template <std::size_t Limbs>
struct GridVec3
{
    FixedInteger<Limbs> x;
    FixedInteger<Limbs> y;
    FixedInteger<Limbs> z;
};

/// The vector from point `from` to point `to` of a flat list of coordinates.
template <std::size_t Limbs, std::size_t Count>
GridVec2<Limbs> gridVector2(const GridCoordinates<Limbs, Count>& c, std::size_t from, std::size_t to)
{
    return {c[2 * to] - c[2 * from], c[2 * to + 1] - c[2 * from + 1]};
}
template <std::size_t Limbs, std::size_t Count>
GridVec3<Limbs> gridVector3(const GridCoordinates<Limbs, Count>& c, std::size_t from, std::size_t to)
{
    return {c[3 * to] - c[3 * from], c[3 * to + 1] - c[3 * from + 1], c[3 * to + 2] - c[3 * from + 2]};
}

template <std::size_t Limbs>
Sign gridOrient2d(const GridCoordinates<Limbs, 6>& points)
{
    const auto u = gridVector2(points, 0, 1);
    const auto v = gridVector2(points, 0, 2);
    return (u.x * v.y - u.y * v.x).sign();
}

template <std::size_t Limbs>
Sign gridIncircle(const GridCoordinates<Limbs, 8>& points)
{
    const auto ca = gridVector2(points, 2, 0);
    const auto cb = gridVector2(points, 2, 1);
    const auto da = gridVector2(points, 3, 0);
    const auto db = gridVector2(points, 3, 1);
    const auto crossC = ca.x * cb.y - ca.y * cb.x;
    const auto crossD = da.x * db.y - da.y * db.x;
    const auto dotC = ca.x * cb.x + ca.y * cb.y;
    const auto dotD = da.x * db.x + da.y * db.y;
    return (dotC * crossD - crossC * dotD).sign();
}

template <std::size_t Limbs>
Sign gridOrient3d(const GridCoordinates<Limbs, 12>& points)
{
    const auto u = gridVector3(points, 0, 1);
    const auto v = gridVector3(points, 0, 2);
    const auto w = gridVector3(points, 0, 3);
    return (u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x))
        .sign();
}

template <std::size_t Limbs>
FixedInteger<2 * Limbs> gridLift(const GridVec3<Limbs>& p)
{
    return p.x * p.x + p.y * p.y + p.z * p.z;
}
template <std::size_t Limbs>
FixedInteger<2 * Limbs> gridMinorXY(const GridVec3<Limbs>& p, const GridVec3<Limbs>& q)
{
    return p.x * q.y - p.y * q.x;
}

/// The same Laplace expansion as InsphereEstimate.
template <std::size_t Limbs>
Sign gridInsphere(const GridCoordinates<Limbs, 15>& points)
{
    const auto a = gridVector3(points, 4, 0);
    const auto b = gridVector3(points, 4, 1);
    const auto c = gridVector3(points, 4, 2);
    const auto d = gridVector3(points, 4, 3);
    const auto liftA = gridLift(a);
    const auto liftB = gridLift(b);
    const auto liftC = gridLift(c);
    const auto liftD = gridLift(d);
    const auto ab = gridMinorXY(a, b) * (d.z * liftC - c.z * liftD);
    const auto ac = gridMinorXY(a, c) * (b.z * liftD - d.z * liftB);
    const auto ad = gridMinorXY(a, d) * (c.z * liftB - b.z * liftC);
    const auto bc = gridMinorXY(b, c) * (d.z * liftA - a.z * liftD);
    const auto bd = gridMinorXY(b, d) * (a.z * liftC - c.z * liftA);
    const auto cd = gridMinorXY(c, d) * (b.z * liftA - a.z * liftB);
    return (ab + ac + ad + bc + bd + cd).sign();
}

}  // namespace mesher::detail
