#include "sizing/attractor_size.h"
#include "sizing/background_size.h"
#include "sizing/combined_size.h"
#include "sizing/shape_sizes.h"
#include "sizing/surface_size.h"
#include "sizing/uniform_size.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace mesher {
namespace {

Vec3 drawPoint(Random& random)
{
    return {random.between(-2.0, 2.0), random.between(-2.0, 2.0), random.between(-2.0, 2.0)};
}

DistanceProfile profileOf(double size, double growth)
{
    DistanceProfile profile;
    profile.size = size;
    profile.growth = growth;
    return profile;
}

TEST(BoxSize, growsWithTheDistanceFromTheBox)
{
    DistanceProfile profile = profileOf(0.1, 0.5);
    profile.plateau = 1.0;
    profile.largest = 3.0;
    profile.reach = 20.0;
    const BoxSize field({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, profile);
    EXPECT_DOUBLE_EQ(field.sizeAt({0.5, 0.5, 0.5}), 0.1);
    EXPECT_DOUBLE_EQ(field.sizeAt({2.0, 0.5, 0.5}), 0.1);
    EXPECT_DOUBLE_EQ(field.sizeAt({4.0, 0.5, 0.5}), 1.1);
    EXPECT_DOUBLE_EQ(field.sizeAt({4.0, 5.0, 0.5}), 0.1 + 0.5 * 4.0);
    EXPECT_DOUBLE_EQ(field.sizeAt({15.0, 0.5, 0.5}), 3.0);
    EXPECT_EQ(field.sizeAt({25.0, 0.5, 0.5}), kNoSize);
}

TEST(BallSize, isSmallestAtTheNearestPointOfABall)
{
    const BallSize field({1.0, 0.0, 0.0}, 0.5, profileOf(0.2, 1.0));
    EXPECT_DOUBLE_EQ(field.sizeAt({1.2, 0.0, 0.0}), 0.2);
    EXPECT_DOUBLE_EQ(field.sizeAt({3.0, 0.0, 0.0}), 1.7);
    EXPECT_DOUBLE_EQ(field.smallestNear({3.0, 0.0, 0.0}, 1.0), 0.7);
    EXPECT_DOUBLE_EQ(field.smallestNear({3.0, 0.0, 0.0}, 9.0), 0.2);
}

TEST(SurfaceSize, agreesWithTheMinimumOverAllTriangles)
{
    Random random(11);
    std::vector<SizedTriangle> triangles;
    for (int i = 0; i < 200; ++i) {
        const Vec3 a = drawPoint(random);
        const Vec3 b = a + 0.2 * drawPoint(random);
        const double size = random.between(0.01, 1.0);
        triangles.push_back(
            {{a, b, a + 0.2 * drawPoint(random)}, {size, size, size}, random.between(0.0, 0.1)});
    }
    const SurfaceSize field(triangles, 0.5);
    for (int i = 0; i < 300; ++i) {
        const Vec3 p = drawPoint(random);
        double smallest = kNoSize;
        for (const SizedTriangle& triangle : triangles) {
            // Of one triangle alone there is no tree to pass anything over.
            smallest = std::min(smallest, SurfaceSize({triangle}, 0.5).sizeAt(p));
        }
        EXPECT_EQ(field.sizeAt(p), smallest);
    }
}

TEST(SurfaceSize, isLinearOnATriangleAndGrowsBeyondThePlateau)
{
    const SizedTriangle triangle = {
        {{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}}}, {1.0, 2.0, 3.0}, 0.5};
    const SurfaceSize field({triangle}, 2.0);
    EXPECT_DOUBLE_EQ(field.sizeAt({1.0, 1.0, 0.3}), 0.5 * 1.0 + 0.25 * 2.0 + 0.25 * 3.0);
    EXPECT_DOUBLE_EQ(field.sizeAt({2.0, 0.0, -1.5}), 1.5 + 2.0);
    EXPECT_DOUBLE_EQ(field.sizeAt({-3.0, 0.0, 0.0}), 1.0 + 2.0 * 2.5);
    EXPECT_DOUBLE_EQ(field.smallestNear({-3.0, 0.0, 0.0}, 1.0), 1.0 + 2.0 * 1.5);
}

TEST(AttractorSize, agreesWithTheMinimumOverAllAttractors)
{
    Random random(3);
    std::vector<Attractor> attractors;
    for (int i = 0; i < 300; ++i) {
        const Vec3 a = drawPoint(random);
        const Vec3 b = i % 3 == 0 ? a : a + 0.2 * drawPoint(random);
        attractors.push_back({a, b, random.between(0.01, 0.5)});
    }
    DistanceProfile profile = profileOf(1.0, 0.7);
    profile.plateau = 0.05;
    const AttractorSize field(attractors, profile);
    for (int i = 0; i < 500; ++i) {
        const Vec3 p = 1.5 * drawPoint(random);
        double expected = kNoSize;
        for (const Attractor& attractor : attractors) {
            // The nearest of many points of the segment, from above.
            double distance = kNoSize;
            for (int k = 0; k <= 200; ++k) {
                const double s = k / 200.0;
                distance = std::min(distance, length(p - ((1.0 - s) * attractor.first + s * attractor.last)));
            }
            expected = std::min(expected, attractor.size + 0.7 * std::max(0.0, distance - 0.05));
        }
        EXPECT_NEAR(field.sizeAt(p), expected, 1e-3);
        EXPECT_LE(field.sizeAt(p), expected + 1e-12);
    }
}

TEST(AttractorSize, withoutAttractorsWishesForNothing)
{
    EXPECT_EQ(AttractorSize({}, {}).sizeAt({}), kNoSize);
}

TEST(CombinedSize, takesTheSmallestBetweenFloorAndCap)
{
    const CombinedSize field(
        {std::make_shared<UniformSize>(2.0), std::make_shared<BallSize>(Vec3{}, 0.0, profileOf(0.01, 1.0))},
        0.1, 1.5);
    EXPECT_DOUBLE_EQ(field.sizeAt({0.0, 0.0, 0.0}), 0.1);
    EXPECT_DOUBLE_EQ(field.sizeAt({1.0, 0.0, 0.0}), 1.01);
    EXPECT_DOUBLE_EQ(field.sizeAt({9.0, 0.0, 0.0}), 1.5);
    EXPECT_DOUBLE_EQ(field.smallestNear({2.0, 0.0, 0.0}, 1.0), 1.01);
}

TEST(SizingField, samplesABallUnlessItKnowsBetter)
{
    struct Spike final : SizingField
    {
        [[nodiscard]] double sizeAt(const Vec3& p) const override { return p.x > 0.9 ? 0.1 : 1.0; }
    };
    EXPECT_EQ(Spike().smallestNear({0.0, 0.0, 0.0}, 1.0), 0.1);
    EXPECT_EQ(Spike().smallestNear({0.0, 0.0, 0.0}, 0.5), 1.0);
}

double linear(const Vec3& p) { return 5.0 + p.x + 0.5 * p.y - 0.25 * p.z; }

TEST(BackgroundSize, reproducesLinearSizesInsideAndTheNearestOutside)
{
    BackgroundMesh mesh;
    for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 1, 1}}) {
        mesh.nodes.push_back(p);
        mesh.sizes.push_back(linear(p));
    }
    mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
    const auto field = BackgroundSize::make(mesh);
    ASSERT_TRUE(field.hasValue());
    for (const Vec3 p : {Vec3{0.2, 0.2, 0.2}, Vec3{0.5, 0.5, 0.5}, Vec3{0.1, 0.7, 0.1}}) {
        EXPECT_NEAR((*field)->sizeAt(p), linear(p), 1e-12);
    }
    EXPECT_NEAR((*field)->sizeAt({-3.0, 0.25, 0.25}), linear({0.0, 0.25, 0.25}), 1e-12);
    EXPECT_NEAR((*field)->sizeAt({-1.0, -1.0, -1.0}), linear({0.0, 0.0, 0.0}), 1e-12);
}

TEST(BackgroundSize, interpolatesOnManyTriangles)
{
    BackgroundMesh mesh;
    constexpr std::uint32_t kSide = 20;
    for (std::uint32_t j = 0; j <= kSide; ++j) {
        for (std::uint32_t i = 0; i <= kSide; ++i) {
            const Vec3 p{i / double{kSide}, j / double{kSide}, 0.0};
            mesh.nodes.push_back(p);
            mesh.sizes.push_back(linear(p));
            const std::uint32_t n = j * (kSide + 1) + i;
            if (i == kSide || j == kSide) continue;
            mesh.triangles.push_back({n, n + 1, n + kSide + 2});
            mesh.triangles.push_back({n, n + kSide + 2, n + kSide + 1});
        }
    }
    const auto field = BackgroundSize::make(mesh);
    ASSERT_TRUE(field.hasValue());
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 p{random.unit(), random.unit(), 0.0};
        EXPECT_NEAR((*field)->sizeAt(p), linear(p), 1e-12);
    }
}

TEST(BackgroundSize, refusesBrokenMeshes)
{
    BackgroundMesh mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.sizes = {1.0, 1.0, 1.0};
    EXPECT_FALSE(BackgroundSize::make(mesh).hasValue());
    mesh.triangles = {{0, 1, 3}};
    EXPECT_FALSE(BackgroundSize::make(mesh).hasValue());
    mesh.triangles = {{0, 1, 2}};
    EXPECT_TRUE(BackgroundSize::make(mesh).hasValue());
    mesh.sizes[1] = 0.0;
    EXPECT_FALSE(BackgroundSize::make(mesh).hasValue());
    mesh.sizes.pop_back();
    EXPECT_FALSE(BackgroundSize::make(mesh).hasValue());
}

}  // namespace
}  // namespace mesher
