#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace mesher {
namespace {

TEST(Random, IsSplitmix64)
{
    // The first values for seed 1234567 that the authors of the generator publish with it.
    Random random(1234567);
    EXPECT_EQ(random(), 6457827717110365317u);
    EXPECT_EQ(random(), 3203168211198807973u);
    EXPECT_EQ(random(), 9817491932198370423u);
}

TEST(Random, StaysBelowTheBoundAndReachesEachValue)
{
    Random random(3);
    std::array<int, 7> counts{};
    for (int i = 0; i < 7000; ++i) {
        const std::uint32_t draw = random.below(7);
        ASSERT_LT(draw, 7u);
        ++counts[draw];
    }
    EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 850);
    EXPECT_LT(*std::max_element(counts.begin(), counts.end()), 1150);
}

TEST(Random, IsUniformOnIntervals)
{
    Random random(4);
    double sum = 0.0;
    double least = 10.0;
    double most = 0.0;
    for (int i = 0; i < 10'000; ++i) {
        const double draw = random.between(2.0, 4.0);
        ASSERT_TRUE(2.0 <= draw && draw < 4.0);
        sum += draw;
        least = std::min(least, draw);
        most = std::max(most, draw);
    }
    EXPECT_NEAR(sum / 10'000, 3.0, 0.03);
    EXPECT_LT(least, 2.01);
    EXPECT_GT(most, 3.99);
}

}  // namespace
}  // namespace mesher
