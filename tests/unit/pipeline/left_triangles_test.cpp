#include "pipeline/left_triangles.h"

#include <gtest/gtest.h>

namespace mesher::test {
namespace {

LeftFacets facetsOf(std::uint32_t face, FacetLeft reason, std::uint64_t count, double leastAngle)
{
    LeftFacets facets;
    facets.face = BrepFaceId(face);
    facets.reason = reason;
    facets.count = count;
    facets.leastAngle = leastAngle;
    facets.largestAngle = 120.0;
    facets.worst = {1.0, 2.0, 3.0};
    return facets;
}

TEST(LeftTriangles, AreInTheReportByFaceAndReason)
{
    MeshReport report;
    tellLeftTriangles({facetsOf(0, FacetLeft::SmallAngle, 4, 11.0), facetsOf(2, FacetLeft::Rim, 7, 3.0)},
                      report);
    ASSERT_EQ(report.left.size(), 2u);
    const LeftElements& first = report.left[0];
    EXPECT_EQ(first.entities, std::vector<std::string>{"Face1"});
    EXPECT_EQ(first.dimension, 2);
    EXPECT_EQ(first.count, 4u);
    EXPECT_EQ(first.leastAngle, 11.0);
    EXPECT_EQ(first.largestAngle, 120.0);
    EXPECT_EQ(first.worst, (Vec3{1.0, 2.0, 3.0}));
    EXPECT_EQ(report.left[1].entities, std::vector<std::string>{"Face3"});
    EXPECT_NE(report.left[1].remedy.find("--max-wall-elements"), std::string::npos);
    EXPECT_NE(first.reason, report.left[1].reason);
}

/// With the sum of their counts, the least of their angles and all their faces.
TEST(LeftTriangles, OfOneReasonShareAWarning)
{
    MeshReport report;
    tellLeftTriangles({facetsOf(0, FacetLeft::Resolution, 4, 21.0),
                       facetsOf(1, FacetLeft::Resolution, 5, 17.0), facetsOf(2, FacetLeft::Rim, 1, 3.0)},
                      report);
    ASSERT_EQ(report.warnings.size(), 2u);
    const auto of = [&](const std::string& words) {
        return report.warnings[0].find(words) != std::string::npos ||
               report.warnings[1].find(words) != std::string::npos;
    };
    EXPECT_TRUE(of("9 triangles at Face1, Face2 have angles below the 30 degrees of --min-angle, down to 17"))
        << report.warnings[0] << report.warnings[1];
    EXPECT_TRUE(of("1 triangles at Face3")) << report.warnings[0] << report.warnings[1];
}

TEST(LeftTriangles, WarnsOfNothingWhereNoneAreLeft)
{
    MeshReport report;
    tellLeftTriangles(std::vector<LeftFacets>{}, report);
    EXPECT_TRUE(report.warnings.empty());
    EXPECT_TRUE(report.left.empty());
}

}  // namespace
}  // namespace mesher::test
