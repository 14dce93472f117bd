#include "quality/tet_measures.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mesher {
namespace {

constexpr TetCorners kRegular = {{{1.0, 1.0, 1.0}, {-1.0, 1.0, -1.0}, {1.0, -1.0, -1.0}, {-1.0, -1.0, 1.0}}};
/// Half a corner of the unit cube.
constexpr TetCorners kCorner = {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

TEST(TetMeasures, ScoreTheRegularTetrahedronAsTheTableSays)
{
    ASSERT_GT(sixfoldVolume(kRegular), 0.0);
    for (const TetMeasureInfo& info : kTetMeasures) {
        EXPECT_NEAR(score(info.measure, kRegular), info.regularScore, 1e-12) << info.key;
    }
}

TEST(TetMeasures, HaveTheThresholdsOfTable42)
{
    const double thresholds[] = {0.52, 0.32, 0.32, 0.36, 0.21, 0.47, 0.59, 0.24};
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(kTetMeasures[i].threshold, thresholds[i]);
        EXPECT_EQ(static_cast<std::size_t>(kTetMeasures[i].measure), i);
        EXPECT_EQ(kTetMeasures[i].key[1], static_cast<char>('1' + static_cast<char>(i)));
        EXPECT_EQ(tetMeasureOf(kTetMeasures[i].key), kTetMeasures[i].measure);
    }
    EXPECT_FALSE(tetMeasureOf("q9"));
    EXPECT_FALSE(tetMeasureOf(""));
}

// By hand: V = 1/6, areas 1/2 (three) and sqrt(3)/2, edges 1 (three) and sqrt(2) (three), R = sqrt(3)/2.
TEST(TetMeasures, ScoreTheCubeCornerAsComputedByHand)
{
    const double root2 = std::numbers::sqrt2;
    const double root3 = std::numbers::sqrt3;
    const double areaSum = 1.5 + root3 / 2.0;
    const double inradius = 0.5 / areaSum;
    EXPECT_NEAR(score(TetMeasure::ShortestEdgeToCircumradius, kCorner), std::sqrt(0.375) * 2.0 / root3,
                1e-14);
    EXPECT_NEAR(score(TetMeasure::MinimumDihedralSine, kCorner), std::sqrt(2.0 / 3.0), 1e-14);
    EXPECT_NEAR(score(TetMeasure::VolumeLength, kCorner), root2 / std::pow(1.5, 1.5), 1e-14);
    EXPECT_NEAR(score(TetMeasure::RadiusRatio, kCorner), 6.0 * inradius / root3, 1e-14);
    // At the far corners: dihedral angles 90, acos(1/sqrt 3) twice, so the solid angle is their sum minus pi.
    const double solidAngle = 2.0 * std::acos(1.0 / root3) - std::numbers::pi / 2.0;
    EXPECT_NEAR(score(TetMeasure::MinimumSolidAngle, kCorner),
                solidAngle / (3.0 * std::acos(1.0 / 3.0) - std::numbers::pi), 1e-14);
    EXPECT_NEAR(score(TetMeasure::MeanRatio, kCorner), 12.0 * std::pow(0.5, 2.0 / 3.0) / 9.0, 1e-14);
    EXPECT_NEAR(score(TetMeasure::InradiusToLargestAltitude, kCorner), 4.0 * 0.5 / areaSum, 1e-14);
    EXPECT_NEAR(score(TetMeasure::AltitudeToLongestEdge, kCorner), std::sqrt(1.5) / root3 / root2, 1e-14);
}

TEST(TetMeasures, ScoreFlatAndInvertedTetrahedraZero)
{
    const TetCorners flat = {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}}};
    TetCorners inverted = kRegular;
    std::swap(inverted[0], inverted[1]);
    for (const TetMeasureInfo& info : kTetMeasures) {
        EXPECT_EQ(score(info.measure, flat), 0.0) << info.key;
        EXPECT_EQ(score(info.measure, inverted), 0.0) << info.key;
        EXPECT_EQ(score(info.measure, TetCorners{}), 0.0) << info.key;
    }
}

/// A sliver: four points near the equator of a sphere.
TetCorners sliver(double height)
{
    return {{{1.0, 0.0, height}, {0.0, 1.0, -height}, {-1.0, 0.0, height}, {0.0, -1.0, -height}}};
}

TEST(TetMeasures, SeeASliverExceptForTheFirst)
{
    TetCorners p = sliver(1e-3);
    if (sixfoldVolume(p) < 0.0) std::swap(p[0], p[1]);
    for (const TetMeasureInfo& info : kTetMeasures) {
        const bool isBlind = info.measure == TetMeasure::ShortestEdgeToCircumradius;
        if (info.measure == TetMeasure::InradiusToLargestAltitude) continue;
        EXPECT_EQ(score(info.measure, p) > info.threshold, isBlind)
            << info.key << ' ' << score(info.measure, p);
    }
}

TEST(DihedralAngles, AreThoseOfTheCubeCorner)
{
    const std::array<double, 6> angles = dihedralAngles(kCorner);
    const double steep = std::acos(1.0 / std::numbers::sqrt3) * 180.0 / std::numbers::pi;
    for (std::size_t edge = 0; edge < 6; ++edge)
        EXPECT_NEAR(angles[edge], edge < 3 ? 90.0 : steep, 1e-12) << edge;
}

TetCorners randomTet(Random& random)
{
    TetCorners p;
    for (Vec3& corner : p) corner = {random.unit(), random.unit(), random.unit()};
    if (sixfoldVolume(p) < 0.0) std::swap(p[0], p[1]);
    return p;
}

TEST(TetMeasures, DoNotDependOnTheNumberingScaleAndPlace)
{
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        const TetCorners p = randomTet(random);
        const TetCorners turned = {p[1], p[2], p[0], p[3]};  // an even permutation
        TetCorners moved = p;
        for (Vec3& corner : moved) corner = 8.0 * corner + Vec3{1.0, 2.0, 3.0};
        for (const TetMeasureInfo& info : kTetMeasures) {
            const double q = score(info.measure, p);
            EXPECT_NEAR(score(info.measure, turned), q, 1e-9) << info.key;
            EXPECT_NEAR(score(info.measure, moved), q, 1e-6) << info.key;
            EXPECT_GT(q, 0.0);
            EXPECT_LE(q, info.regularScore + 1e-12) << info.key;
        }
    }
}

TEST(TetMeasures, AgreeWithTheDihedralAngles)
{
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        const TetCorners p = randomTet(random);
        double sine = 1.0;
        for (const double angle : dihedralAngles(p))
            sine = std::min(sine, std::sin(angle * std::numbers::pi / 180.0));
        EXPECT_NEAR(score(TetMeasure::MinimumDihedralSine, p), sine, 1e-9);
    }
}

}  // namespace
}  // namespace mesher
