#include "predicates/exact_tiers.h"
#include "predicates/incircle.h"
#include "predicates/insphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/predicate_tiers.h"
#include "support/exact_oracle.h"
#include "support/predicate_points.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace mesher {
namespace {

using test::kPointKindCount;
using test::makePointSets;
using test::PointKind;

/// Odd and of 49 bits: three such factors do not fit a double.
constexpr double kLong = 0x1.23456789012bp48;

/// Points of the line y = x and of the plane z = x + y that need `finest` besides kLong.
std::vector<Vec2> onLine(double finest)
{
    return {{0, 0}, {kLong, kLong}, {finest, finest}, {-kLong, -kLong}};
}
std::vector<Vec3> onPlane(double finest)
{
    return {{0, 0, 0}, {kLong, 0, kLong}, {0, finest, finest}, {-kLong, 0, -kLong}, {0, -finest, -finest}};
}

Decision orient2dOf(const std::vector<Vec2>& p, const StaticFilter2d& filter = {})
{
    return decideOrient2d(filter, p[0], p[1], p[2]);
}
Decision incircleOf(const std::vector<Vec2>& p, const StaticFilter2d& filter = {})
{
    return decideIncircle(filter, p[0], p[1], p[2], p[3]);
}
Decision orient3dOf(const std::vector<Vec3>& p, const StaticFilter3d& filter = {})
{
    return decideOrient3d(filter, p[0], p[1], p[2], p[3]);
}
Decision insphereOf(const std::vector<Vec3>& p, const StaticFilter3d& filter = {})
{
    return decideInsphere(filter, p[0], p[1], p[2], p[3], p[4]);
}

const std::vector<Vec2> kPlain2{{0, 0}, {1, 0}, {0, 1}, {0.25, 0.25}};
const std::vector<Vec3> kPlain3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0.25, 0.25}};

TEST(PredicateTiers, StaticFilterDecidesPlainPointsOfItsBox)
{
    const auto filter2 = StaticFilter2d::forBox({{0, 0}, {1, 1}});
    const auto filter3 = StaticFilter3d::forBox({{0, 0, 0}, {1, 1, 1}});
    const Decision expected{Sign::Positive, Tier::StaticFilter};
    EXPECT_EQ(orient2dOf(kPlain2, filter2), expected);
    EXPECT_EQ(incircleOf(kPlain2, filter2), expected);
    EXPECT_EQ(orient3dOf(kPlain3, filter3), expected);
    EXPECT_EQ(insphereOf(kPlain3, filter3), expected);
}

TEST(PredicateTiers, SemiStaticFilterDecidesWhereTheBoxIsTooLarge)
{
    const auto filter2 = StaticFilter2d::forBox({{-1e9, -1e9}, {1e9, 1e9}});
    const auto filter3 = StaticFilter3d::forBox({{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}});
    const Decision expected{Sign::Positive, Tier::SemiStaticFilter};
    EXPECT_EQ(orient2dOf(kPlain2, filter2), expected);
    EXPECT_EQ(incircleOf(kPlain2, filter2), expected);
    EXPECT_EQ(orient3dOf(kPlain3, filter3), expected);
    EXPECT_EQ(insphereOf(kPlain3, filter3), expected);
}

TEST(PredicateTiers, PointsThatAgreeInOneCoordinateAreFlat)
{
    const Decision expected{Sign::Zero, Tier::Flat};
    const std::vector<Vec2> vertical{{0.1, 1}, {0.1, 2.3}, {0.1, -7}, {0.1, 5}};
    const std::vector<Vec3> level{{0.3, 1, 0.1}, {0.7, 2, 0.1}, {0.2, 8, 0.1}, {1, 1, 0.1}, {0, 0.2, 0.1}};
    EXPECT_EQ(orient2dOf(vertical), expected);
    EXPECT_EQ(incircleOf(vertical), expected);
    EXPECT_EQ(orient3dOf(level), expected);
    EXPECT_EQ(insphereOf(level), expected);
}

TEST(PredicateTiers, ShortCoordinatesAreDecidedInDoubles)
{
    const Decision expected{Sign::Zero, Tier::Short};
    const std::vector<Vec2> square{{8, 8}, {9, 8}, {9, 9}, {8, 9}};
    const std::vector<Vec3> cube{{8, 8, 8}, {9, 8, 8}, {9, 9, 8}, {8, 8, 9}, {9, 9, 9}};
    EXPECT_EQ(incircleOf(square), expected);
    EXPECT_EQ(insphereOf(cube), expected);
    EXPECT_EQ(orient2dOf({{0, 0}, {3, 1}, {6, 2}}), expected);
    EXPECT_EQ(orient3dOf({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}}), expected);
}

TEST(PredicateTiers, LongCoordinatesAreDecidedInIntegers)
{
    const Decision narrow{Sign::Zero, Tier::Integer64};
    EXPECT_EQ(orient2dOf(onLine(3)), narrow);
    EXPECT_EQ(incircleOf(onLine(3)), narrow);
    EXPECT_EQ(orient3dOf(onPlane(3)), narrow);
    EXPECT_EQ(insphereOf(onPlane(3)), narrow);
    const Decision wide{Sign::Zero, Tier::Integer128};
    EXPECT_EQ(orient2dOf(onLine(0x1p-60)), wide);
    EXPECT_EQ(incircleOf(onLine(0x1p-60)), wide);
    EXPECT_EQ(orient3dOf(onPlane(0x1p-60)), wide);
    EXPECT_EQ(insphereOf(onPlane(0x1p-60)), wide);
}

TEST(PredicateTiers, ExponentsFarApartAreDecidedByExpansions)
{
    const Decision expected{Sign::Zero, Tier::Expansion};
    EXPECT_EQ(orient2dOf(onLine(0x1p-150)), expected);
    EXPECT_EQ(incircleOf(onLine(0x1p-150)), expected);
    EXPECT_EQ(orient3dOf(onPlane(0x1p-150)), expected);
    EXPECT_EQ(insphereOf(onPlane(0x1p-150)), expected);
}

TEST(PredicateTiers, IntegerTiersRefuseWhatDoesNotFit)
{
    const auto line = onLine(0x1p-150);
    EXPECT_FALSE(detail::orient2dShort(line[0], line[1], line[2]));
    EXPECT_FALSE(detail::orient2dInteger64(line[0], line[1], line[2]));
    EXPECT_FALSE(detail::orient2dInteger128(line[0], line[1], line[2]));
}

/// All tiers that are able to decide, and the production functions, with exact integers of any size.
void expectAgreement(const std::vector<Vec2>& p)
{
    using namespace detail;
    const test::ExactOracle2d oracle(p);
    const Sign orientation = oracle.orientation();
    ASSERT_EQ(orient2dShort(p[0], p[1], p[2]).value_or(orientation), orientation);
    ASSERT_EQ(orient2dInteger64(p[0], p[1], p[2]).value_or(orientation), orientation);
    ASSERT_EQ(orient2dInteger128(p[0], p[1], p[2]).value_or(orientation), orientation);
    ASSERT_EQ(orient2dExpansion(p[0], p[1], p[2]), orientation);
    ASSERT_EQ(orient2dOf(p).sign, orient2d(p[0], p[1], p[2]));
    const Sign circle = oracle.sphere();
    ASSERT_EQ(incircleShort(p[0], p[1], p[2], p[3]).value_or(circle), circle);
    ASSERT_EQ(incircleInteger64(p[0], p[1], p[2], p[3]).value_or(circle), circle);
    ASSERT_EQ(incircleInteger128(p[0], p[1], p[2], p[3]).value_or(circle), circle);
    ASSERT_EQ(incircleExpansion(p[0], p[1], p[2], p[3]), circle);
    ASSERT_EQ(incircleOf(p).sign, incircle(p[0], p[1], p[2], p[3]));
}
void expectAgreement(const std::vector<Vec3>& p)
{
    using namespace detail;
    const test::ExactOracle3d oracle(p);
    const Sign orientation = oracle.orientation();
    ASSERT_EQ(orient3dShort(p[0], p[1], p[2], p[3]).value_or(orientation), orientation);
    ASSERT_EQ(orient3dInteger64(p[0], p[1], p[2], p[3]).value_or(orientation), orientation);
    ASSERT_EQ(orient3dInteger128(p[0], p[1], p[2], p[3]).value_or(orientation), orientation);
    ASSERT_EQ(orient3dExpansion(p[0], p[1], p[2], p[3]), orientation);
    ASSERT_EQ(orient3dOf(p).sign, orient3d(p[0], p[1], p[2], p[3]));
    const Sign sphere = oracle.sphere();
    ASSERT_EQ(insphereShort(p[0], p[1], p[2], p[3], p[4]).value_or(sphere), sphere);
    ASSERT_EQ(insphereInteger64(p[0], p[1], p[2], p[3], p[4]).value_or(sphere), sphere);
    ASSERT_EQ(insphereInteger128(p[0], p[1], p[2], p[3], p[4]).value_or(sphere), sphere);
    ASSERT_EQ(insphereExpansion(p[0], p[1], p[2], p[3], p[4]), sphere);
    ASSERT_EQ(insphereOf(p).sign, insphere(p[0], p[1], p[2], p[3], p[4]));
}

TEST(PredicateTiers, Agree)
{
    for (std::size_t kind = 0; kind < kPointKindCount; ++kind) {
        for (std::uint64_t i = 0; i < 5000; ++i) {
            SCOPED_TRACE(std::string(test::kPointKindNames[kind]) + " " + std::to_string(i));
            const auto sets = makePointSets(static_cast<PointKind>(kind), 3, i);
            expectAgreement(sets.plane);
            expectAgreement(sets.space);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(PredicateTiers, LargestAndSmallestCoordinatesNeitherOverflowNorUnderflow)
{
    for (const double unit : {0x1p200, 0x1p-200}) {
        const Vec3 o{0, 0, 0}, x{unit, 0, 0}, y{0, unit, 0}, z{0, 0, unit}, n{-unit, -unit, -unit};
        expectAgreement(std::vector<Vec3>{o, x, y, z, {unit, unit, unit}});
        expectAgreement(std::vector<Vec3>{n, x, y, z, {unit, unit, unit}});
        EXPECT_EQ(orient3d(o, x, y, z), Sign::Positive);
        EXPECT_EQ(insphere(o, x, y, z, {unit, unit, unit}), Sign::Zero);
        EXPECT_EQ(detail::insphereExpansion(n, x, y, z, o), Sign::Positive * orient3d(n, x, y, z));
        expectAgreement(std::vector<Vec2>{{-unit, -unit}, {unit, -unit}, {unit, unit}, {-unit, unit}});
    }
    // Neighbours at the fine end beside the largest coordinates.
    const Vec3 far{0x1p200, -0x1p200, 0x1p200};
    expectAgreement(std::vector<Vec3>{far, {0, 0, 0}, {0x1p-200, 0, 0}, {0, 0x1p-200, 0}, {0, 0, 0x1p-200}});
}

}  // namespace
}  // namespace mesher
