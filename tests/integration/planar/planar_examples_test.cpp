#include "base/run_context.h"
#include "support/planar_examples.h"
#include "triangulation2d/planar_check.h"

#include <gtest/gtest.h>
#include <iostream>

namespace mesher {
namespace {

class PlanarExamples : public ::testing::TestWithParam<std::size_t>
{
};

TEST_P(PlanarExamples, keepTheirPromises)
{
    const test::PlanarExample example = test::allPlanarExamples()[GetParam()];
    PlanarOptions options;
    if (example.name[0]=='b') options.refinement.sizing.refinement = 3.0;
    options.limits.maxVertices = 1'000'000;
    RunContext context;
    const auto result = triangulatePlanar(example.complex, options, context);
    ASSERT_TRUE(result.hasValue()) << describe(result.error());
    EXPECT_EQ(result->stopReason, StopReason::Done);
    const PlanarCheck check = checkPlanar(example.complex, *result, options);
    for (const std::string& violation : check.violations) ADD_FAILURE() << violation;
    EXPECT_LT(check.angles.largest, 137.0);
    std::cout << result->refinement.splitting.blocked << " " << result->refinement.splitting.blockedAcrossUnmeshed << " " << result->refinement.splitting.outsideCircles << " " << result->counts.enrichment.intersectionSplits << "\n";
    std::cout << example.name << ": " << result->counts.vertices << " vertices " << result->counts.triangles
              << " triangles, angles " << check.angles.smallest << " to " << check.angles.largest << '\n';
}

INSTANTIATE_TEST_SUITE_P(All, PlanarExamples,
                         ::testing::Range<std::size_t>(0, test::allPlanarExamples().size()),
                         [](const auto& example) { return test::allPlanarExamples()[example.param].name; });

}  // namespace
}  // namespace mesher
