#include "brep/model_inspection.h"

#include "brep/analytic/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

TEST(ModelInspection, MeasuresSolidsOfKnownArea)
{
    const ModelFacts box = inspectModel(makeBox({}, {1.0, 2.0, 3.0}).value());
    EXPECT_NEAR(box.area, 22.0, 1e-12);
    EXPECT_NEAR(box.length, 24.0, 1e-12);
    EXPECT_NEAR(box.smallestEdge.value().length, 1.0, 1e-15);
    EXPECT_NEAR(box.smallestAngle.value().degrees, 90.0, 1e-12);
    EXPECT_EQ(box.facesByType, (std::map<std::string, std::size_t>{{"plane", 6}}));
    EXPECT_TRUE(box.freeEdges.empty() && box.nonManifoldEdges.empty() && box.slivers.empty() && box.gaps.empty());
    EXPECT_NEAR(inspectModel(makeSphere({}, 2.0).value()).area, 16.0 * kPi, 1e-4);
    EXPECT_NEAR(inspectModel(makeTorus({}, 3.0, 1.0).value()).area, 12.0 * kPi * kPi, 1e-4);
    const ModelFacts cylinder = inspectModel(makeCylinder({}, 1.0, 2.0).value());
    EXPECT_NEAR(cylinder.area, 6.0 * kPi, 1e-4);
    EXPECT_EQ(cylinder.facesByType, (std::map<std::string, std::size_t>{{"cylinder", 1}, {"plane", 2}}));
    EXPECT_EQ(inspectModel(makeSphere({}, 2.0).value()).degenerateEdges, 2u);
}

TEST(ModelInspection, FindsSliversGapsTolerancesAndFreeEdges)
{
    BrepModel model = makeBox({}, {10.0, 0.01, 10.0}).value();
    model.faces[BrepFaceId(0u)].loops[0].coedges[1].gap = 0.5;
    model.edges[BrepEdgeId(3u)].tolerance = 0.25;
    const ModelFacts facts = inspectModel(model);
    EXPECT_EQ(facts.slivers.size(), 4u);
    EXPECT_NEAR(facts.slivers.front().width, 0.01, 1e-4);
    ASSERT_EQ(facts.gaps.size(), 1u);
    EXPECT_EQ(facts.gaps[0].face, BrepFaceId(0u));
    EXPECT_EQ(facts.largestTolerance.entity, "Edge4");
    EXPECT_EQ(facts.looseTolerances, 1u);
    model.faces[BrepFaceId(2u)].loops[0].coedges.clear();
    EXPECT_EQ(inspectModel(model).freeEdges.size(), 4u);
    EXPECT_TRUE(inspectModel(model).looseEdges.empty());
}

TEST(ModelInspection, TextAndJsonSayTheFacts)
{
    BrepModel model = makeBox({}, {1.0, 2.0, 3.0}).value();
    model.notes = {"Edge3 says \"no\"\n"};
    const ModelFacts facts = inspectModel(model);
    EXPECT_NE(textOf(facts).find("6 plane"), std::string::npos);
    EXPECT_NE(textOf(facts).find("smallest edge: Edge1, 1"), std::string::npos);
    const std::string json = jsonOf(facts);
    EXPECT_NE(json.find("\"faces_by_type\": {\"plane\": 6}"), std::string::npos) << json;
    EXPECT_NE(json.find("\"Edge3 says \\\"no\\\"\\u000a\""), std::string::npos) << json;
    EXPECT_EQ(std::count(json.begin(), json.end(), '{'), std::count(json.begin(), json.end(), '}'));
}

}  // namespace mesher
