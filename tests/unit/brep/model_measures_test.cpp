#include "brep/model_measures.h"

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace mesher {
namespace {

constexpr double kPi = std::numbers::pi;

ModelMeasures measured(const BrepModel& model)
{
    RunContext context;
    return measureModel(model, context);
}

SolidVolume volumeOf(const BrepModel& model) { return measured(model).volume; }

void expectVolume(const Result<BrepModel>& model, double exact)
{
    ASSERT_TRUE(model);
    const SolidVolume volume = volumeOf(model.value());
    EXPECT_NEAR(volume.value, exact, 2e-6 * exact);
    EXPECT_LT(volume.uncertainty, 1e-4 * exact);
}

TEST(ModelMeasures, IsThatOfSimpleSolidsAnywhere)
{
    const Axes axes = {{3.0, -20.0, 7.0}, {0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}};
    expectVolume(makeBox({10.0, 20.0, 30.0}, {11.0, 22.0, 33.0}), 6.0);
    expectVolume(makeCylinder(axes, 2.0, 5.0), 20.0 * kPi);
    expectVolume(makeCone(axes, 2.0, 0.0, 3.0), 4.0 * kPi);
    expectVolume(makeSphere(axes, 1.5), 4.5 * kPi);
    expectVolume(makeTorus(axes, 4.0, 1.0), 8.0 * kPi * kPi);
}

TEST(ModelMeasures, HasTheAreaOfEachFace)
{
    const Axes axes = {{1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}};
    const ModelMeasures cylinder = measured(makeCylinder(axes, 2.0, 5.0).value());
    std::vector<double> areas(cylinder.areaOf.begin(), cylinder.areaOf.end());
    std::sort(areas.begin(), areas.end());
    ASSERT_EQ(areas.size(), 3u);
    EXPECT_NEAR(areas[0], 4.0 * kPi, 1e-4);
    EXPECT_NEAR(areas[1], 4.0 * kPi, 1e-4);
    EXPECT_NEAR(areas[2], 20.0 * kPi, 1e-9);
    EXPECT_NEAR(cylinder.area(), 28.0 * kPi, 2e-4);
    EXPECT_NEAR(measured(makeTorus(axes, 4.0, 1.0).value()).area(), 16.0 * kPi * kPi, 1e-5);
}

TEST(ModelMeasures, AreLeftWhenTheRunIsCancelled)
{
    RunContext context;
    context.requestCancel();
    const ModelMeasures measures = measureModel(makeBox({}, {1.0, 1.0, 1.0}).value(), context);
    EXPECT_EQ(measures.area(), 0.0);
    EXPECT_EQ(measures.areaOf.size(), 6u);
}

TEST(ModelMeasures, TellsThatAnOpenShellHasNone)
{
    BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    model.solids[BrepSolidId(0)].shells[0].faces.pop_back();
    EXPECT_GT(volumeOf(model).uncertainty, 0.5);
}

TEST(ModelMeasures, TellsThatAFaceIsTurned)
{
    BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    EXPECT_LT(volumeOf(model).uncertainty, 1e-12);
    BrepShellFace& face = model.solids[BrepSolidId(0)].shells[0].faces[1];
    face.isReversed = !face.isReversed;
    EXPECT_GT(volumeOf(model).uncertainty, 0.5);
}

}  // namespace
}  // namespace mesher
