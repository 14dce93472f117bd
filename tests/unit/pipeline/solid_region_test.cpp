#include "pipeline/solid_region.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace mesher {
namespace {

using Triangles = std::vector<std::array<Vec3, 3>>;

/// A box of twelve triangles, of which every second one is turned.
void addBox(Triangles& triangles, const Vec3& low, const Vec3& high)
{
    const auto corner = [&](int i) {
        return Vec3{(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                    (i & 4) != 0 ? high.z : low.z};
    };
    constexpr std::array<std::array<int, 4>, 6> kSides = {
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    for (const auto& side : kSides) {
        triangles.push_back({corner(side[0]), corner(side[1]), corner(side[2])});
        triangles.push_back({corner(side[0]), corner(side[3]), corner(side[2])});
    }
}

TEST(SolidRegion, TellsInsideFromOutsideHoweverTrianglesAreTurned)
{
    Triangles triangles;
    addBox(triangles, {0.0, 0.0, 0.0}, {4.0, 3.0, 2.0});
    addBox(triangles, {1.0, 1.0, 0.5}, {2.0, 2.0, 1.5});  // a void
    const SolidRegion region(triangles);
    Random random(5);
    int inside = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 p = {random.between(-1.0, 5.0), random.between(-1.0, 4.0), random.between(-1.0, 3.0)};
        const bool isInBox = p.x > 0.0 && p.x < 4.0 && p.y > 0.0 && p.y < 3.0 && p.z > 0.0 && p.z < 2.0;
        const bool isInVoid = p.x > 1.0 && p.x < 2.0 && p.y > 1.0 && p.y < 2.0 && p.z > 0.5 && p.z < 1.5;
        ASSERT_EQ(region.contains(p), isInBox && !isInVoid) << p.x << ' ' << p.y << ' ' << p.z;
        inside += isInBox && !isInVoid ? 1 : 0;
    }
    EXPECT_GT(inside, 500);
}

/// Points below the corners and edges of the triangles, along the ray.
TEST(SolidRegion, CountsRaysThroughCornersAndEdgesOnce)
{
    Triangles triangles;
    addBox(triangles, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
    const SolidRegion region(triangles);
    const Vec3 ray = {0.318309886, 0.141421356, 1.0};
    for (const auto& triangle : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (const double share : {0.0, 0.25, 0.5}) {
                const Vec3 target = (1.0 - share) * triangle[i] + share * triangle[(i + 1) % 3];
                for (const double depth : {0.1, 0.4, 5.0}) {
                    const Vec3 p = target - depth * ray;
                    const double reach = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
                    if (std::abs(reach - 1.0) < 1e-6) continue;  // on the surface
                    EXPECT_EQ(region.contains(p), reach < 1.0) << p.x << ' ' << p.y << ' ' << p.z;
                }
            }
        }
    }
}

}  // namespace
}  // namespace mesher
