#include "io/write_curved_boundary.h"

#include "support/temp_dir.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace mesher {
namespace {

TEST(CurvedBoundaryFile, HasTheDocumentedContent)
{
    const test::TempDir folder;
    CurvedBoundary boundary;
    boundary.order = 2;
    CurvedBoundaryEdge edge;
    edge.curve = {1, 4};
    edge.node = {NodeId(0), NodeId(6)};
    edge.parameter = {0.0, 0.1};
    edge.left = {2, 0};
    edge.points = {{0.05, {1.0, 2.0, 0.0}, {0.0, -1.0, 0.0}, 0.1, 0.5}};
    boundary.edges = {edge, edge};
    Result<AtomicFile> target = prepareCurvedBoundary(boundary, folder.path() / "b.json");
    ASSERT_TRUE(target && target->commit());
    std::ifstream file(folder.path() / "b.json");
    std::ostringstream text;
    text << file.rdbuf();
    const std::string one =
        "  {\"curve\": \"Edge5\", \"nodes\": [1, 7], \"parameters\": [0, 0.1], \"left\": \"Face1\", "
        "\"right\": \"\",\n"
        "   \"gauss\": [{\"parameter\": 0.05, \"point\": [1, 2, 0], \"normal\": [0, -1, 0], \"weight\": 0.1, "
        "\"curvature\": 0.5}],\n"
        "   \"halves\": [[], []]}";
    EXPECT_EQ(text.str(),
              "{\"format\": \"mesher-curved-boundary\", \"version\": 1, \"unit\": \"mm\", \"order\": 2,\n"
              " \"edges\": [\n" +
                  one + ",\n" + one + "\n]}\n");
}

}  // namespace
}  // namespace mesher
