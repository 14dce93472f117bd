#include "base/run_context.h"
#include "delaunay/mesh_hash2d.h"
#include "support/planar_examples.h"
#include "support/planar_figures.h"
#include "triangulation2d/planar_check.h"

#include <gtest/gtest.h>
#include <string>

namespace mesher {
namespace {

/// Beside input angles below 60 degrees [miller2003]; elsewhere planar_check.h holds the angles to 30 and 120 degrees.
constexpr double kLargestAngle = 137.0;

std::uint64_t hashOf(const PlanarResult& result) { return meshHash2d(result.triangulation.mesh()); }

class PlanarExamples : public ::testing::TestWithParam<std::size_t>
{
};

TEST_P(PlanarExamples, keepTheirPromises)
{
    const test::PlanarFigure figure = test::planarFigures()[GetParam()];
    RunContext context;
    const auto result = triangulatePlanar(figure.complex, figure.options, context);
    ASSERT_TRUE(result.hasValue()) << describe(result.error());
    EXPECT_EQ(result->stopReason, StopReason::Done);
    const PlanarCheck check = checkPlanar(figure.complex, *result, figure.options);
    for (const std::string& violation : check.violations) ADD_FAILURE() << violation;
    EXPECT_LT(check.angles.largest, kLargestAngle);
    const bool hasSmallAngles = result->triangulation.smallAngles.complexes.size() > 0;
    EXPECT_EQ(check.angles.smallest < 30.0, hasSmallAngles);
    const auto again = triangulatePlanar(figure.complex, figure.options, context);
    EXPECT_EQ(hashOf(*again), hashOf(*result));
}

INSTANTIATE_TEST_SUITE_P(All, PlanarExamples, ::testing::Range<std::size_t>(0, test::planarFigures().size()),
                         [](const auto& figure) { return test::planarFigures()[figure.param].name; });

SubcurveSplitCounters2d splittingOf(const std::string& name)
{
    for (const test::PlanarFigure& figure : test::planarFigures()) {
        if (figure.name != name) continue;
        RunContext context;
        return triangulatePlanar(figure.complex, figure.options, context)->refinement.splitting;
    }
    ADD_FAILURE() << "there is no example " << name;
    return {};
}

/// Fig. 2.10.
TEST(SpecialInsertions, splitWhatIsInTheWayFirst)
{
    const SubcurveSplitCounters2d splitting = splittingOf("overlapping_hulls");
    EXPECT_GT(splitting.blocked, splitting.blockedAcrossUnmeshed);
}

/// Fig. 2.11.
TEST(SpecialInsertions, insertOutsideOfAllCircles)
{
    EXPECT_GT(splittingOf("bulge_outside_of_circles").outsideCircles, 0u);
}

/// Fig. 2.12: without looking across the hole the new edges would cross the outer arc's.
TEST(SpecialInsertions, lookAcrossAnUnmeshedRegion)
{
    EXPECT_GT(splittingOf("thin_hole_between_arcs").blockedAcrossUnmeshed, 0u);
}

}  // namespace
}  // namespace mesher
