#include "surface_sampling/curve_division.h"

#include "brep/analytic/axes.h"
#include "brep/analytic/bspline_curve.h"
#include "brep/analytic/conic_curves.h"
#include "brep/analytic/line_curve.h"
#include "sizing/shape_sizes.h"
#include "sizing/uniform_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

namespace mesher {
namespace {

constexpr double kPi = std::numbers::pi;

CurveWishes wishesFor(double maxVariation, const SizingField* sizes = nullptr)
{
    CurveWishes wishes;
    wishes.maxVariation = maxVariation;
    wishes.sizes = sizes;
    wishes.floor = 1e-6;
    return wishes;
}

std::vector<double> divided(const TangentVariation& table, const CurveWishes& wishes)
{
    RunContext context;
    StepWatch watch(context);
    return divideCurve(table, wishes, watch);
}

std::size_t piecesOf(const TangentVariation& table, const CurveWishes& wishes)
{
    const std::vector<double> ends = divided(table, wishes);
    EXPECT_EQ(ends.front(), table.part().first);
    EXPECT_EQ(ends.back(), table.part().last);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) EXPECT_LT(ends[i], ends[i + 1]);
    return ends.size() - 1;
}

TangentVariation line(double length)
{
    return {std::make_shared<LineCurve>(LineCurve::between({}, {length, 0.0, 0.0})), {0.0, length}};
}

TangentVariation circle(double radius)
{
    return {std::make_shared<CircleCurve>(Axes{}, radius, Interval{0.0, 2.0 * kPi}), {0.0, 2.0 * kPi}};
}

TEST(CurveDivision, MakesPiecesNearestToTheSize)
{
    const UniformSize size(1.0);
    EXPECT_EQ(piecesOf(line(1.4), wishesFor(1.0, &size)), 1u);
    EXPECT_EQ(piecesOf(line(1.5), wishesFor(1.0, &size)), 2u);
    EXPECT_EQ(piecesOf(line(2.4), wishesFor(1.0, &size)), 2u);
    EXPECT_EQ(piecesOf(line(2.6), wishesFor(1.0, &size)), 3u);
    EXPECT_EQ(piecesOf(line(9.8), wishesFor(1.0, &size)), 10u);
}

/// Nearly nothing at the origin, and growing by the distance from there.
class SizeOfDistance final : public SizingField
{
public:
    [[nodiscard]] double sizeAt(const Vec3& p) const override { return 1e-300 + length(p); }
    [[nodiscard]] double smallestNear(const Vec3& centre, double radius) const override
    {
        return 1e-300 + std::max(0.0, length(centre) - radius);
    }
};

TEST(CurveDivision, CountsAsManyPiecesAsSizesThatGrowFromNearlyNothingMake)
{
    const SizeOfDistance size;
    const double exact = std::log(1e300);
    const auto pieces = static_cast<double>(piecesOf(line(1.0), wishesFor(1.0, &size)));
    // The first of them are all at one place.
    EXPECT_GT(pieces, 0.5 * exact);
    EXPECT_LT(pieces, 1.05 * exact);
}

TEST(CurveDivision, EndsWhenTheRunDoes)
{
    RunContext context;
    context.requestCancel();
    StepWatch watch(context);
    const UniformSize size(1e-3);
    EXPECT_EQ(divideCurve(line(1.0), wishesFor(1.0, &size), watch).size(), 1u);
}

/// Sizes are counted over all of a smooth curve, not over each of the pieces that turning alone would make.
TEST(CurveDivision, CountsSizesAndTurningTogether)
{
    const TangentVariation whole = circle(1.0);
    const UniformSize size(2.0 * kPi / 10.0);
    EXPECT_EQ(piecesOf(whole, wishesFor(kPi / 4.0)), 8u);
    EXPECT_EQ(piecesOf(whole, wishesFor(kPi / 4.0, &size)), 10u);
    const UniformSize coarse(2.0 * kPi / 4.0);
    EXPECT_EQ(piecesOf(whole, wishesFor(kPi / 4.0, &coarse)), 8u);
}

TEST(CurveDivision, KeepsToTurningAndSagInEachPiece)
{
    const auto curve = *BSplineCurve::make(
        {.degree = 3,
         .poles = {{0, 0, 0}, {5, 0, 0}, {5.2, 0.1, 0}, {5.2, 3, 0}, {5.1, 4, 0}, {9, 4, 1}, {12, 3, 0}},
         .weights = {},
         .knots = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}});
    const TangentVariation table(curve, {0.0, 4.0});
    const BallSize size({5.0, 0.0, 0.0}, 1.0, DistanceProfile{.size = 0.3, .growth = 0.5});
    CurveWishes wishes = wishesFor(0.4, &size);
    wishes.maxSag = 0.01;
    const std::vector<double> ends = divided(table, wishes);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double turning = table.variation(ends[i], ends[i + 1]);
        EXPECT_LE(turning, 0.4 * (1.0 + 1e-5));
        EXPECT_LE(table.arcLength(ends[i], ends[i + 1]) * turning / 8.0, 0.01 * (1.0 + 1e-5));
        const double middle = 0.5 * (ends[i] + ends[i + 1]);
        EXPECT_LE(table.arcLength(ends[i], ends[i + 1]), 1.5 * size.sizeAt(curve->position(middle)));
    }
}

TEST(CurveDivision, GivesAClosedCurveItsPiecesAndEndsAtTheFloor)
{
    CurveWishes wishes = wishesFor(2.0 * kPi);
    wishes.leastPieces = 3;
    EXPECT_EQ(piecesOf(circle(1.0), wishes), 3u);
    wishes.maxVariation = 1e-3;
    wishes.floor = 0.1;
    EXPECT_EQ(piecesOf(circle(1.0), wishes), 62u);
    wishes.mostPieces = 50.0;
    EXPECT_TRUE(divided(circle(1.0), wishes).empty());
}

}  // namespace
}  // namespace mesher
