#include "brep/solid_volume.h"

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"

#include <gtest/gtest.h>

#include <numbers>

namespace mesher {
namespace {

constexpr double kPi = std::numbers::pi;

void expectVolume(const Result<BrepModel>& model, double exact)
{
    ASSERT_TRUE(model);
    const SolidVolume volume = volumeOf(model.value());
    EXPECT_NEAR(volume.value, exact, 2e-6 * exact);
    EXPECT_LT(volume.uncertainty, 1e-4 * exact);
}

TEST(SolidVolume, IsThatOfSimpleSolidsAnywhere)
{
    const Axes axes = {{3.0, -20.0, 7.0}, {0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}};
    expectVolume(makeBox({10.0, 20.0, 30.0}, {11.0, 22.0, 33.0}), 6.0);
    expectVolume(makeCylinder(axes, 2.0, 5.0), 20.0 * kPi);
    expectVolume(makeCone(axes, 2.0, 0.0, 3.0), 4.0 * kPi);
    expectVolume(makeSphere(axes, 1.5), 4.5 * kPi);
    expectVolume(makeTorus(axes, 4.0, 1.0), 8.0 * kPi * kPi);
}

TEST(SolidVolume, TellsThatAnOpenShellHasNone)
{
    BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    model.solids[BrepSolidId(0)].shells[0].faces.pop_back();
    EXPECT_GT(volumeOf(model).uncertainty, 0.5);
}

TEST(SolidVolume, TellsThatAFaceIsTurned)
{
    BrepModel model = makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).value();
    EXPECT_LT(volumeOf(model).uncertainty, 1e-12);
    BrepShellFace& face = model.solids[BrepSolidId(0)].shells[0].faces[1];
    face.isReversed = !face.isReversed;
    EXPECT_GT(volumeOf(model).uncertainty, 0.5);
}

}  // namespace
}  // namespace mesher
