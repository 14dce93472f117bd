#include "pipeline/mesh_options.h"

#include <gtest/gtest.h>

#include <limits>

namespace mesher {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Change>
void expectRefused(Change change, const std::string& option)
{
    MeshOptions options;
    change(options);
    const Result<void> valid = validate(options);
    ASSERT_FALSE(valid) << option;
    EXPECT_EQ(valid.error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(valid.error().entity, option);
    EXPECT_FALSE(valid.error().remedy.empty());
}

TEST(MeshOptions, AreValidByDefault) { EXPECT_TRUE(validate({})); }

TEST(MeshOptions, RefuseSizesThatMakeNoSense)
{
    for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity}) {
        expectRefused([bad](MeshOptions& o) { o.size = bad; }, "--size");
        expectRefused([bad](MeshOptions& o) { o.minSize = bad; }, "--min-size");
        expectRefused([bad](MeshOptions& o) { o.localSizes = {{"Face1", bad}}; }, "--local-size");
        expectRefused([bad](MeshOptions& o) { o.timeout = bad; }, "--timeout");
    }
    expectRefused(
        [](MeshOptions& o) {
            o.size = 1.0;
            o.minSize = 2.0;
        },
        "--min-size");
    for (const double bad : {-1.0, kNan, kInfinity})
        expectRefused([bad](MeshOptions& o) { o.sag = bad; }, "--sag");
}

TEST(MeshOptions, RefuseBoxesBallsDistancesAndFormulasThatMakeNoSense)
{
    const SizeInBox box = {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, 0.1, {}};
    const SizeInBall ball = {{0.0, 0.0, 0.0}, 1.0, 0.1, {}};
    const SizeByDistance distance = {"Edge1", 0.1, 0.0, 0.0};
    MeshOptions good;
    good.boxSizes = {box};
    good.ballSizes = {ball};
    good.distanceSizes = {distance};
    good.sizeFormula = "0.1 + x^2";
    good.dimension = 2;
    good.faces = {"Face1", "Face12"};
    EXPECT_TRUE(validate(good));
    const auto refuseAll = [&](auto SizeInBox::*boxMember, auto SizeInBall::*ballMember, double bad) {
        expectRefused([&](MeshOptions& o) { (o.boxSizes = {box})[0].*boxMember = bad; }, "--size-box");
        expectRefused([&](MeshOptions& o) { (o.ballSizes = {ball})[0].*ballMember = bad; }, "--size-ball");
    };
    for (const double bad : {-1.0, kNan, kInfinity}) {
        refuseAll(&SizeInBox::size, &SizeInBall::size, bad);
        refuseAll(&SizeInBox::growth, &SizeInBall::growth, bad);
        expectRefused([&](MeshOptions& o) { (o.ballSizes = {ball})[0].radius = bad; }, "--size-ball");
        expectRefused([&](MeshOptions& o) { (o.distanceSizes = {distance})[0].size = bad; },
                      "--size-distance");
        expectRefused([&](MeshOptions& o) { (o.distanceSizes = {distance})[0].growth = bad; },
                      "--size-distance");
        expectRefused([&](MeshOptions& o) { (o.distanceSizes = {distance})[0].plateau = bad; },
                      "--size-distance");
    }
    for (const double bad : {kNan, kInfinity}) {
        expectRefused([&](MeshOptions& o) { (o.boxSizes = {box})[0].first.y = bad; }, "--size-box");
        expectRefused([&](MeshOptions& o) { (o.boxSizes = {box})[0].last.z = bad; }, "--size-box");
        expectRefused([&](MeshOptions& o) { (o.ballSizes = {ball})[0].centre.x = bad; }, "--size-ball");
    }
    expectRefused([](MeshOptions& o) { o.sizeFormula = "0.1 + y+"; }, "--size-formula");
    expectRefused([](MeshOptions& o) { o.dimension = 2, o.faces = {"Edge1"}; }, "--faces");
    expectRefused([](MeshOptions& o) { o.faces = {"Face1"}; }, "--faces");  // of solids all is meshed
}

TEST(MeshOptions, RefuseWhatIsOutOfRange)
{
    for (const double bad : {kNan, -1.0, 1e9}) {
        expectRefused([bad](MeshOptions& o) { o.curvature = bad; }, "--curvature");
        expectRefused([bad](MeshOptions& o) { o.refinement = bad; }, "--refinement");
        expectRefused([bad](MeshOptions& o) { o.grading = bad; }, "--grading");
        expectRefused([bad](MeshOptions& o) { o.minAngle = bad; }, "--min-angle");
        expectRefused([bad](MeshOptions& o) { o.maxTurn = bad; }, "--max-turn");
        expectRefused([bad](MeshOptions& o) { o.threshold = bad; }, "--threshold");
        expectRefused([bad](MeshOptions& o) { o.maxDihedral = bad; }, "--max-dihedral");
        expectRefused([bad](MeshOptions& o) { o.lambda = bad; }, "--lambda");
    }
    expectRefused([](MeshOptions& o) { o.threshold = 0.0; }, "--threshold");
    expectRefused([](MeshOptions& o) { o.grading = 0.0; }, "--grading");
    expectRefused([](MeshOptions& o) { o.dimension = 4; }, "--dimension");
    expectRefused([](MeshOptions& o) { o.order = 3; }, "--order");
    expectRefused([](MeshOptions& o) { o.threads = 0; }, "--threads");
    expectRefused([](MeshOptions& o) { o.maxElements = 0; }, "--max-elements");
    expectRefused([](MeshOptions& o) { o.maxElements = 2'000'000'000; }, "--max-elements");
}

}  // namespace
}  // namespace mesher
