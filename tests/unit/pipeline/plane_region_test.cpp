#include "pipeline/plane_region.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {
namespace {

void addCircle(std::vector<PlaneRegion::Chord>& boundary, Vec2 centre, double radius, bool isTurned)
{
    constexpr int kChords = 1000;
    const auto at = [&](int i) {
        const double angle = 2.0 * std::numbers::pi * i / kChords;
        return Vec2{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
    };
    for (int i = 0; i < kChords; ++i) {
        const PlaneRegion::Chord chord = {at(i), at(i + 1)};
        boundary.push_back(isTurned ? PlaneRegion::Chord{chord[1], chord[0]} : chord);
    }
}

/// A disc with two holes, one of them with an island, in a tilted plane.
TEST(PlaneRegion, TellsInsideFromOutsideWhateverTheDirectionOfTheChords)
{
    std::vector<PlaneRegion::Chord> boundary;
    addCircle(boundary, {0.0, 0.0}, 3.0, false);
    addCircle(boundary, {1.0, 0.5}, 1.0, true);
    addCircle(boundary, {1.0, 0.5}, 0.4, true);
    addCircle(boundary, {-1.5, 0.0}, 0.5, false);
    PlaneFrame frame;
    frame.origin = {1.0, 2.0, 3.0};
    frame.xAxis = {0.0, 0.6, 0.8};
    frame.yAxis = {1.0, 0.0, 0.0};
    frame.normal = cross(frame.xAxis, frame.yAxis);
    const PlaneRegion region(frame, boundary);
    Random random(3);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p = {random.between(-4.0, 4.0), random.between(-4.0, 4.0)};
        const auto distance = [&](Vec2 centre, double radius) { return length(p - centre) - radius; };
        const double outer = distance({0.0, 0.0}, 3.0), hole = distance({1.0, 0.5}, 1.0);
        const double island = distance({1.0, 0.5}, 0.4), other = distance({-1.5, 0.0}, 0.5);
        const double nearest = std::min({std::abs(outer), std::abs(hole), std::abs(island), std::abs(other)});
        if (nearest < 1e-4) continue;
        const bool isInside = outer < 0.0 && (hole > 0.0 || island < 0.0) && other > 0.0;
        inside += isInside;
        EXPECT_EQ(region.contains(frame.toSpace(p) + 0.3 * frame.normal), isInside) << p.x << ' ' << p.y;
    }
    EXPECT_GT(inside, 5000);
}

TEST(PlaneRegion, WithoutAreaContainsNothing)
{
    EXPECT_FALSE(PlaneRegion({}, {}).contains({}));
    EXPECT_FALSE(PlaneRegion({}, {{{{0.0, 0.0}, {1.0, 0.0}}}}).contains({0.5, 0.0, 0.0}));
}

}  // namespace
}  // namespace mesher
