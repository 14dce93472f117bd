#include "brep/analytic/solids.h"

#include "brep/analytic/round_surfaces.h"
#include "support/model_contract.h"
#include "support/surface_contract.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesher {

namespace {

const Axes kTilted{{1.0, -2.0, 0.5}, {0.6, 0.8, 0.0}, {0.0, 0.0, 1.0}, {0.8, -0.6, 0.0}};
const Axes kMirrored{{1.0, -2.0, 0.5}, {0.6, 0.8, 0.0}, {0.0, 0.0, 1.0}, {-0.8, 0.6, 0.0}};

void expectContract(const Result<BrepModel>& model, std::size_t faces, std::size_t edges)
{
    ASSERT_TRUE(model) << describe(model.error());
    const test::ContractReport report = test::checkModelContract(*model, {40, true});
    EXPECT_EQ(report.faces, faces);
    EXPECT_EQ(report.edges, edges);
    EXPECT_LT(report.largestGap, 1e-14);
    for (const std::string& line : report.broken) ADD_FAILURE() << line;
}

/// Every face's normal points away from the inside point.
void expectOutward(const BrepModel& model, const Vec3& inside)
{
    for (const BrepFace& face : model.faces) {
        const SurfacePoint p = face.surface->evaluate({face.boundsU.at(0.4), face.boundsV.at(0.6)});
        EXPECT_GT(dot(p.normal(), p.position - inside), 0.0);
    }
}

}  // namespace

TEST(AnalyticSolids, KeepTheContract)
{
    expectContract(makeBox({1.0, 2.0, 3.0}, {2.0, 4.0, 7.0}), 6, 12);
    expectContract(makeCylinder(kTilted, 2.0, 3.0), 3, 3);
    expectContract(makeCone(kTilted, 2.0, 1.0, 3.0), 3, 3);
    expectContract(makeCone(kTilted, 2.0, 0.0, 3.0), 2, 3);
    expectContract(makeCone(kTilted, 1.0, 4.0, 0.5), 3, 3);
    expectContract(makeSphere(kTilted, 2.0), 1, 3);
    expectContract(makeTorus(kTilted, 2.0, 0.5), 1, 2);
}

TEST(AnalyticSolids, NormalsPointOutwards)
{
    expectOutward(makeBox({-1.0, -1.0, -1.0}, {1.0, 2.0, 3.0}).value(), {});
    const Vec3 inside = kTilted.toSpace({0.1, 0.1, 0.5});
    expectOutward(makeCylinder(kTilted, 2.0, 3.0).value(), inside);
    expectOutward(makeCone(kTilted, 2.0, 1.0, 3.0).value(), inside);
    expectOutward(makeSphere(kTilted, 2.0).value(), inside);
}

TEST(AnalyticSolids, BadSizesAreRefused)
{
    EXPECT_FALSE(makeBox({}, {1.0, 0.0, 1.0}));
    EXPECT_FALSE(makeBox({}, {1.0, std::nan(""), 1.0}));
    EXPECT_FALSE(makeCylinder({}, -1.0, 1.0));
    EXPECT_FALSE(makeCone({}, 1.0, -1.0, 1.0));
    EXPECT_FALSE(makeSphere({}, HUGE_VAL));
    EXPECT_FALSE(makeTorus({}, 1.0, 1.0));
}

TEST(RoundSurfaces, SelfCrossingAndMirroredOnesKeepTheContract)
{
    const auto expectSurface = [](const Surface& surface, Interval v) {
        for (const auto& line : test::findBrokenPromises(surface, surface.rangeU(), v, 10.0, 60)) ADD_FAILURE() << line;
    };
    expectSurface(TorusSurface(kTilted, 1.0, 1.5), {0.0, RoundSurface::kTurn});
    expectSurface(TorusSurface(kTilted, 1.0, 1.0), {0.0, RoundSurface::kTurn});
    expectSurface(ConeSurface(kTilted, 1.0, 0.5), {-6.0, 3.0});
    expectSurface(ConeSurface(kMirrored, 1.0, -0.5), {-1.0, 6.0});
    expectSurface(CylinderSurface(kMirrored, 2.0), {-1.0, 1.0});
    expectSurface(SphereSurface(kMirrored, 2.0), {-1.5, 1.5});
}

TEST(RoundSurfaces, CurvaturesAreTheKnownOnes)
{
    const auto of = [](const Surface& surface, Vec2 uv) { return curvatureOf(surface.evaluate(uv)).value(); };
    EXPECT_NEAR(of(SphereSurface(kTilted, 4.0), {1.0, 0.5}).smallest, -0.25, 1e-13);
    EXPECT_NEAR(of(CylinderSurface(kTilted, 4.0), {1.0, 0.5}).largest, -0.25, 1e-14);
    EXPECT_NEAR(of(CylinderSurface(kMirrored, 4.0), {1.0, 0.5}).largest, 0.25, 1e-14);
    EXPECT_NEAR(of(CylinderSurface(kTilted, 4.0), {1.0, 0.5}).smallest, 0.0, 1e-14);
    EXPECT_NEAR(of(TorusSurface(kTilted, 4.0, 1.0), {1.0, 0.0}).largest, -1.0, 1e-14);
    EXPECT_NEAR(of(TorusSurface(kTilted, 4.0, 1.0), {1.0, 0.0}).smallest, -0.2, 1e-14);
}

TEST(RoundSurfaces, ASeedKeepsTheSheetTheImageAndThePole)
{
    const ConeSurface cone({}, 1.0, 0.25 * std::numbers::pi);
    const Vec3 belowApex{1.2, 0.0, -1.1};
    EXPECT_GT(cone.project(belowApex, Vec2{0.0, 1.0}).parameters.y, -std::sqrt(2.0));
    EXPECT_LT(cone.project(belowApex, Vec2{0.0, -3.0}).parameters.y, -std::sqrt(2.0));
    const CylinderSurface cylinder({}, 1.0);
    EXPECT_NEAR(cylinder.project({1.0, 0.01, 0.0}, Vec2{6.2, 0.0}).parameters.x, 6.283185307179586 + 0.01, 1e-6);
    EXPECT_EQ(SphereSurface({}, 1.0).project({0.0, 0.0, 2.0}, Vec2{1.25, 1.5}).parameters.x, 1.25);
}

}  // namespace mesher
