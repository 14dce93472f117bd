#pragma once

#include "base/vec.h"

#include <cmath>

namespace mesher {

/// What refinement asks about a triangle; from its corners, counter-clockwise.
struct TriangleShape2d
{
    double squaredRadius = 0.0;  ///< of the circumcircle
    double squaredShortest = 0.0;
    unsigned shortestEdge = 0;  ///< opposite of the corner with this number
    double doubleArea = 0.0;

    /// (r / l)^2; the smallest angle a has r / l = 1 / (2 sin a).
    [[nodiscard]] double squaredRatio() const { return squaredRadius / squaredShortest; }

    [[nodiscard]] static TriangleShape2d of(Vec2 a, Vec2 b, Vec2 c)
    {
        TriangleShape2d shape;
        const double squares[3] = {squaredLength(c - b), squaredLength(a - c), squaredLength(b - a)};
        shape.doubleArea = cross(b - a, c - a);
        shape.squaredRadius =
            squares[0] * squares[1] * squares[2] / (4.0 * shape.doubleArea * shape.doubleArea);
        shape.shortestEdge = squares[1] < squares[0] ? 1 : 0;
        if (squares[2] < squares[shape.shortestEdge]) shape.shortestEdge = 2;
        shape.squaredShortest = squares[shape.shortestEdge];
        return shape;
    }
};

/// Whether one of a triangle's angles is wider than the obtuse one with this cosine.
[[nodiscard]] inline bool hasAngleWiderThan(double cosine, Vec2 a, Vec2 b, Vec2 c)
{
    const auto isWide = [cosine](Vec2 u, Vec2 v) {
        return dot(u, v) < cosine * std::sqrt(squaredLength(u) * squaredLength(v));
    };
    return isWide(b - a, c - a) || isWide(c - b, a - b) || isWide(a - c, b - c);
}

/// The centre of the circle through three points; inexact, and far away or not finite for collinear ones.
[[nodiscard]] inline Vec2 circumcenter(Vec2 a, Vec2 b, Vec2 c)
{
    const Vec2 u = b - a;
    const Vec2 v = c - a;
    const double uu = squaredLength(u);
    const double vv = squaredLength(v);
    const double factor = 0.5 / cross(u, v);
    return {a.x + (v.y * uu - u.y * vv) * factor, a.y + (u.x * vv - v.x * uu) * factor};
}

}  // namespace mesher
