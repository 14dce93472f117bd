#include "brep/analytic/round_surfaces.h"
#include "surface_sampling/face_pinch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

using namespace mesher;

namespace {

constexpr double kPi = std::numbers::pi;

std::optional<Error> refusal(std::shared_ptr<const Surface> surface, Interval v)
{
    BrepModel model;
    model.faces.resize(1);
    BrepFace& face = model.faces[BrepFaceId(0)];
    face.surface = std::move(surface);
    face.boundsU = {0.0, kPi};
    face.boundsV = v;
    return refusePinch(model, BrepFaceId(0));
}

std::shared_ptr<const Surface> torus(double ring, double tube)
{
    return std::make_shared<TorusSurface>(Axes{}, ring, tube);
}

}  // namespace

TEST(FacePinch, IsRefusedByTheFaceAndThePoint)
{
    const std::optional<Error> horn = refusal(torus(1.0, 1.0), {0.0, 2.0 * kPi});
    ASSERT_TRUE(horn);
    EXPECT_EQ(horn->entity, "Face1");
    EXPECT_NEAR(length(*horn->point), 0.0, 1e-9);
    const std::optional<Error> spindle = refusal(torus(1.0, 1.5), {0.0, 2.0 * kPi});
    ASSERT_TRUE(spindle);
    EXPECT_NEAR(std::abs(spindle->point->z), std::sqrt(1.25), 1e-9);
    EXPECT_TRUE(refusal(torus(1.0, 1.5), {7.0, 7.0 + kPi}));  // in the second turn
    EXPECT_TRUE(refusal(std::make_shared<ConeSurface>(Axes{}, 1.0, 0.5), {-6.0, 3.0}));
}

TEST(FacePinch, IsNoneWhereTheFaceEndsThere)
{
    const double pinch = std::acos(-1.0 / 1.5);
    EXPECT_FALSE(refusal(torus(1.0, 1.5), {-pinch, pinch}));
    EXPECT_FALSE(refusal(torus(1.0, 1.5), {pinch, 2.0 * kPi - pinch}));
    EXPECT_FALSE(refusal(torus(1.0, 1.0), {0.0, kPi}));
    EXPECT_FALSE(refusal(torus(2.0, 0.5), {0.0, 2.0 * kPi}));
    EXPECT_FALSE(refusal(std::make_shared<ConeSurface>(Axes{}, 1.0, 0.5), {-1.0 / std::sin(0.5), 3.0}));
    EXPECT_FALSE(refusal(std::make_shared<SphereSurface>(Axes{}, 1.0), {-0.5 * kPi, 0.5 * kPi}));
}
