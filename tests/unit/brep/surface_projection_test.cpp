#include "brep/analytic/bspline_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesher {

namespace {

/// A sheet between half of an oval and the point in its middle, where it has a pole.
BSplineSurface fan()
{
    BSplineSurfaceData data;
    data.degreeU = 3;
    data.degreeV = 1;
    data.knotsU = {0, 0, 0, 0, 1, 1, 1, 1};
    data.knotsV = {0, 0, 1, 1};
    for (const Vec3 rim :
         {Vec3{1.0, 0.0, 0.0}, Vec3{1.0, 2.0, 0.0}, Vec3{-1.0, 2.0, 0.0}, Vec3{-1.0, 0.0, 0.0}}) {
        data.poles.push_back({0.0, 0.0, 0.0});
        data.poles.push_back(rim);
    }
    return BSplineSurface(data, {0.0, 1.0}, {0.0, 1.0});
}

}  // namespace

TEST(SurfaceProjectionWithoutSeed, LeavesAPoleInEveryDirection)
{
    const BSplineSurface surface = fan();
    for (const double u : {0.0, 0.2, 0.5, 0.8, 1.0}) {
        // Nearer to the pole than to any other point of the grid.
        const Vec3 on = surface.position({u, 0.015});
        EXPECT_LT(surface.project(on + Vec3{0.0, 0.0, 0.002}).distance, 0.002 + 1e-12) << u;
        // Beyond the rim the closest point is on it.
        const Vec3 beyond = on + Vec3{0.0, -0.002, 0.0};
        if (u == 0.0 || u == 1.0) {
            EXPECT_NEAR(surface.project(beyond).distance, 0.002, 1e-12) << u;
        }
    }
}

TEST(SurfaceProjectionWithoutSeed, FindsThePoleItself)
{
    EXPECT_NEAR(fan().project({0.0, -0.3, 0.4}).distance, 0.5, 1e-12);
}

}  // namespace mesher
