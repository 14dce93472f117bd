#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace mesher::test {
namespace {

/// A ring in a groove of a block, turned in it so that the facets of the two cross.
BrepModel ringInGroove(double tube)
{
    Axes turned;
    turned.x = {std::cos(0.3), std::sin(0.3), 0.0};
    turned.y = {-std::sin(0.3), std::cos(0.3), 0.0};
    const BrepModel block =
        withHollow(*makeBox({-4.0, -4.0, -2.0}, {4.0, 4.0, 2.0}), *makeTorus({}, 2.0, 1.0));
    return together(block, *makeTorus(turned, 2.0, tube));
}

MeshOutcome meshOf(const BrepModel& model, double size)
{
    MeshOptions options;
    options.size = size;
    options.isImproved = false;
    RunContext context;
    return meshSolids(model, options, nullptr, context);
}

TEST(ComponentContacts, TellARingInItsGrooveFromOneThatIsTooThick)
{
    for (const double size : {0.6, 1.0}) {
        const MeshOutcome touching = meshOf(ringInGroove(1.0), size);
        for (const Error& error : touching.report.failures) ADD_FAILURE() << describe(error);
        EXPECT_TRUE(touching.mesh);
        const auto isTold = [](const std::string& text) { return text.find("touch") != std::string::npos; };
        EXPECT_TRUE(std::any_of(touching.report.warnings.begin(), touching.report.warnings.end(), isTold));
    }
    const MeshOutcome thick = meshOf(ringInGroove(1.05), 0.6);
    ASSERT_FALSE(thick.report.warnings.empty());
    EXPECT_NE(thick.report.warnings.front().find("the solids overlap"), std::string::npos);
}

/// The volume that a warning of an overlap tells.
double toldVolume(const MeshReport& report)
{
    constexpr std::string_view kBefore = "they have about ";
    for (const std::string& warning : report.warnings) {
        const std::size_t at = warning.find(kBefore);
        if (at != std::string::npos) return std::stod(warning.substr(at + kBefore.size()));
    }
    return 0.0;
}

/// A pin pressed into a bore by a hundredth to a tenth of what the facets depart from the faces.
TEST(ComponentContacts, TellTheVolumeOfAPressFitFinerThanFacets)
{
    Axes below;
    below.origin = {0.0, 0.0, -1.0};
    for (const double excess : {0.002, 0.02}) {
        const BrepModel block =
            withHollow(*makeBox({-4.0, -4.0, -3.0}, {4.0, 4.0, 3.0}), *makeCylinder(below, 2.0, 2.0));
        const MeshOutcome outcome = meshOf(together(block, *makeCylinder(below, 2.0 + excess, 2.0)), 1.0);
        EXPECT_TRUE(outcome.report.failures.empty());
        const double common = 3.14159265358979 * ((2.0 + excess) * (2.0 + excess) - 4.0) * 2.0;
        EXPECT_NEAR(toldVolume(outcome.report), common, 0.25 * common);
    }
}

TEST(ComponentContacts, FindNoOverlapOfAPinInTheHoleOfARing)
{
    // They touch along the ring's inner equator, a saddle, and nowhere else.
    Axes below;
    below.origin = {0.0, 0.0, -2.0};
    const MeshOutcome outcome =
        meshOf(together(*makeTorus({}, 3.0, 1.0), *makeCylinder(below, 2.0, 4.0)), 0.8);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    EXPECT_TRUE(outcome.mesh);
}

}  // namespace
}  // namespace mesher::test
