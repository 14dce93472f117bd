#include "improvement/dihedral_score.h"

#include "base/random.h"
#include "improvement/least_direction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mesher {
namespace {

TetCorners regularTet() { return {Vec3{1, 1, 1}, Vec3{-1, 1, -1}, Vec3{1, -1, -1}, Vec3{-1, -1, 1}}; }

Vec3 randomVector(Random& random)
{
    return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

TetCorners randomTet(Random& random)
{
    TetCorners tet;
    do {
        for (Vec3& p : tet) p = randomVector(random);
    } while (sixfoldVolume(tet) < 0.1);
    return tet;
}

/// From the angles themselves.
double slowScore(const TetCorners& tet)
{
    double least = 1.0;
    for (const double angle : dihedralAngles(tet)) {
        const double sine = std::sin(angle * std::numbers::pi / 180.0);
        least = std::min(least, angle > 90.0 ? kObtuseWeight * sine : sine);
    }
    return least;
}

TEST(DihedralScore, IsTheLeastWeightedSine)
{
    EXPECT_NEAR(dihedralScore(regularTet()), 2.0 * std::numbers::sqrt2 / 3.0, 1e-12);
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const TetCorners tet = randomTet(random);
        EXPECT_NEAR(dihedralScore(tet), slowScore(tet), 1e-9);
    }
}

TEST(DihedralScore, IsZeroOfFlatAndInvertedTetrahedra)
{
    TetCorners tet = regularTet();
    std::swap(tet[0], tet[1]);
    EXPECT_EQ(dihedralScore(tet), 0.0);
    EXPECT_EQ(dihedralScore({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}}), 0.0);
}

/// The gradient of the least sine, told from differences.
TEST(DihedralScore, HasTheGradientThatDifferencesHave)
{
    constexpr double kStep = 1e-6;
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const TetCorners tet = randomTet(random);
        const double score = dihedralScore(tet);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const ScoreGradients found = scoreGradients(tet, corner, 1.0000001 * score);
            ASSERT_EQ(found.count, 1u);
            const Vec3 way = randomVector(random);
            TetCorners ahead = tet;
            TetCorners behind = tet;
            ahead[corner] = ahead[corner] + kStep * way;
            behind[corner] = behind[corner] - kStep * way;
            const double slope =
                (std::log(dihedralScore(ahead)) - std::log(dihedralScore(behind))) / kStep;  // of the square
            EXPECT_NEAR(dot(found.gradient[0], way), slope, 1e-4 * (1.0 + std::abs(slope)));
        }
    }
}

TEST(DihedralScore, GivesGradientsOfAllSinesUpToTheCeiling)
{
    EXPECT_EQ(scoreGradients(regularTet(), 0, 0.95).count, 6u);
    EXPECT_EQ(scoreGradients(regularTet(), 0, 0.9).count, 0u);
}

TEST(LeastOfHull, IsTheShortestOfManyCombinations)
{
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        std::vector<Vec3> gradients;
        for (std::uint32_t n = 2 + random.below(4); n > 0; --n)
            gradients.push_back(Vec3{1.5, 0, 0} + randomVector(random));
        const Vec3 found = leastOfHull(gradients);
        for (const Vec3& g : gradients) EXPECT_GE(dot(g, found), 0.94 * squaredLength(found));
        for (int trial = 0; trial < 200; ++trial) {
            Vec3 sum;
            double weight = 0.0;
            for (const Vec3& g : gradients) {
                const double w = random.unit();
                sum = sum + w * g;
                weight += w;
            }
            EXPECT_GE(length(sum) / weight, 0.98 * length(found));
        }
    }
}

TEST(LeastOfHull, IsNearlyZeroWhereNoDirectionRaisesAll)
{
    const std::vector<Vec3> gradients = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -2, 0}};
    EXPECT_LT(length(leastOfHull(gradients)), 1e-9);
    EXPECT_EQ(length(leastOfHull({})), 0.0);
}

}  // namespace
}  // namespace mesher
