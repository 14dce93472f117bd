#include "base/backlog_watch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesher::test {
namespace {

/// Vertices when it is told to be stuck, or 0, for a backlog that is `bad(vertices)`.
template <typename Bad>
std::uint64_t stuckAt(std::uint64_t first, Bad&& bad)
{
    BacklogWatch watch;
    for (std::uint64_t vertices = first; vertices < 100 * first; ++vertices) {
        if (watch.isDue(vertices) &&
            watch.look(vertices, static_cast<std::uint64_t>(bad(static_cast<double>(vertices)))))
            return vertices;
    }
    return 0;
}

TEST(BacklogWatch, LetsABacklogBeWorkedOff)
{
    EXPECT_EQ(stuckAt(1000, [](double v) { return 1000.0 * std::pow(1000.0 / v, 2.0); }), 0U);
    EXPECT_EQ(stuckAt(1000, [](double v) { return 500.0 * 1000.0 / v; }), 0U);
}

TEST(BacklogWatch, TellsOneThatGrowsWithTheMeshWhileThatIsStillSmall)
{
    const std::uint64_t at = stuckAt(1000, [](double v) { return 0.02 * 5.0 * v; });
    EXPECT_GT(at, 1000U);
    EXPECT_LT(at, 2000U);
}

TEST(BacklogWatch, TellsOneThatIsWorkedOffAtFirst)
{
    const std::uint64_t at =
        stuckAt(1000, [](double v) { return 2000.0 * std::exp(-(v / 500.0)) + 0.02 * v; });
    EXPECT_GT(at, 1500U);
    EXPECT_LT(at, 10000U);
}

TEST(BacklogWatch, DoesNotCountAFew)
{
    EXPECT_EQ(stuckAt(1000, [](double) { return 15.0; }), 0U);
}

TEST(BacklogWatch, LooksAtOnceAndThenSeldom)
{
    BacklogWatch watch;
    EXPECT_TRUE(watch.isDue(5));
    watch.look(5, 100);
    EXPECT_FALSE(watch.isDue(204));
    EXPECT_TRUE(watch.isDue(205));
    watch.look(10000, 50);
    EXPECT_FALSE(watch.isDue(12499));
    EXPECT_TRUE(watch.isDue(12500));
}

}  // namespace
}  // namespace mesher::test
