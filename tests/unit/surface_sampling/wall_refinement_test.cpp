#include "surface_sampling/wall_refinement.h"

#include "brep/analytic/solids.h"
#include "support/model_union.h"
#include "surface_sampling/sample_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher::test {
namespace {

constexpr double kThickness = 0.05;

/// Of spheres, the first of which bounds the only solid from outside; those that follow are its voids.
RegionSides sidesOfSpheres(std::size_t count)
{
    RegionSides sides;
    for (std::size_t i = 0; i < count; ++i) {
        sides.push_back(i == 0 ? std::array{RegionId(0u), RegionId(1u)}
                               : std::array{RegionId(1u), RegionId(0u)});
    }
    return sides;
}

struct HollowSphere
{
    BrepModel model = together(*makeSphere(Axes{}, 1.0), *makeSphere(Axes{}, 1.0 - kThickness));
    RegionSides sides = sidesOfSpheres(2);
};

SurfaceSample sample(const HollowSphere& sphere, WallRefinementOptions walls)
{
    SurfaceSamplingOptions options;
    options.facets.maxSize = 0.5;
    options.walls = walls;
    options.walls.sides = &sphere.sides;
    RunContext context;
    return std::move(*sampleSurface(sphere.model, options, context));
}

double longestEdge(const SurfaceMesh& mesh)
{
    double longest = 0.0;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            longest = std::max(longest, length(mesh.nodes[facet.node[i]].position -
                                               mesh.nodes[facet.node[(i + 1) % 3]].position));
        }
    }
    return longest;
}

/// Of what is between the two spheres.
double volumeOf(const SurfaceMesh& mesh)
{
    double volume = 0.0;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        const Vec3 &a = mesh.nodes[facet.node[0]].position, &b = mesh.nodes[facet.node[1]].position,
                   &c = mesh.nodes[facet.node[2]].position;
        volume += (facet.face.value == 0 ? 1.0 : -1.0) * dot(a, cross(b, c)) / 6.0;
    }
    return volume;
}

TEST(WallRefinement, MakesFacetsFollowAThinShellCloselyForItsThickness)
{
    const HollowSphere sphere;
    const SurfaceSample result = sample(sphere, {});
    EXPECT_EQ(result.stopReason, StopReason::Done);
    EXPECT_TRUE(result.counts.walls.left.empty());
    EXPECT_DOUBLE_EQ(result.counts.walls.sagShare, WallRefinementOptions().maxSagShare);
    EXPECT_LE(longestEdge(result.surface->mesh()), std::sqrt(8.0 * 0.05 * kThickness));
    const double exact = 4.0 / 3.0 * std::numbers::pi * (1.0 - std::pow(1.0 - kThickness, 3.0));
    EXPECT_NEAR(volumeOf(result.surface->mesh()), exact, 0.02 * exact);
}

TEST(WallRefinement, KeepsAWallThatTakesTooMuchCoarseAndTellsHowCoarse)
{
    const HollowSphere sphere;
    WallRefinementOptions walls;
    walls.maxTets = 1000.0;
    const SurfaceSample result = sample(sphere, walls);
    EXPECT_EQ(result.stopReason, StopReason::Done);
    EXPECT_LT(result.counts.facets, 2000u);
    EXPECT_TRUE(result.counts.certificate.errors.empty());
    ASSERT_EQ(result.counts.walls.left.size(), 1u);
    const CoarseWall& wall = result.counts.walls.left.front();
    EXPECT_EQ(wall.face, (std::array{BrepFaceId(0u), BrepFaceId(1u)}));
    EXPECT_NEAR(wall.thickness, kThickness, 1e-9);
    EXPECT_GT(wall.sagShare, walls.maxSagShare);
}

/// A wall that is made good follows its faces as closely as the facets that it may take allow.
TEST(WallRefinement, StaysWithinItsFacets)
{
    const HollowSphere sphere;
    WallRefinementOptions walls;
    walls.maxSagShare = 0.005;
    walls.maxTets = 30000.0;
    const SurfaceSample result = sample(sphere, walls);
    EXPECT_TRUE(keptOf(result.counts.surveyedWalls).empty());
    EXPECT_GT(result.counts.walls.sagShare, 2.0 * walls.maxSagShare);
    EXPECT_LT(static_cast<double>(result.counts.facets), walls.maxTets);
}

TEST(WallRefinement, LeavesABallAsCoarseAsItIsWished)
{
    BrepModel ball = *makeSphere(Axes{}, 1.0);
    const RegionSides sides = sidesOfSpheres(1);
    SurfaceSamplingOptions options;
    options.facets.maxSize = 0.5;
    options.walls.sides = &sides;
    RunContext context;
    const SurfaceSample result = std::move(*sampleSurface(ball, options, context));
    EXPECT_EQ(result.counts.walls.facetsSplit, 0u);
}

}  // namespace
}  // namespace mesher::test
