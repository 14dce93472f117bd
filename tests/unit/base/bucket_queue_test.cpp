#include "base/bucket_queue.h"

#include "base/ids.h"
#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace mesher {
namespace {

using Queue = BucketQueue<TetId>;

std::vector<std::uint32_t> drain(Queue& queue)
{
    std::vector<std::uint32_t> ids;
    while (const auto entry = queue.pop()) ids.push_back(entry->id.value);
    return ids;
}

TEST(BucketQueue, GivesTheWorstFirst)
{
    Queue queue;
    queue.push(TetId(0), 0, 1.0);
    queue.push(TetId(1), 0, 4.0);
    queue.push(TetId(2), 0, 0.5);
    queue.push(TetId(3), 0, 2.0);
    EXPECT_EQ(queue.size(), 4u);
    EXPECT_EQ(drain(queue), (std::vector<std::uint32_t>{1, 3, 0, 2}));
    EXPECT_TRUE(queue.empty());
    EXPECT_FALSE(queue.pop().has_value());
}

TEST(BucketQueue, GivesEqualKeysInTheOrderOfInsertion)
{
    Queue queue;
    for (std::uint32_t i = 0; i < 10; ++i) queue.push(TetId(i), 0, 3.0);
    EXPECT_EQ(drain(queue), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(BucketQueue, KeepsTheEntryAsItWasPushed)
{
    Queue queue;
    queue.push(TetId(7), 65535, 0.125);
    const auto entry = queue.pop();
    ASSERT_TRUE(entry.has_value());
    EXPECT_EQ(entry->id, TetId(7));
    EXPECT_EQ(entry->generation, 65535);
    EXPECT_EQ(entry->key, 0.125);
}

TEST(BucketQueue, DropsStaleEntriesOnTheWay)
{
    Queue queue;
    queue.push(TetId(0), 1, 8.0);
    queue.push(TetId(1), 5, 4.0);
    queue.push(TetId(2), 1, 2.0);
    const std::vector<std::uint16_t> present = {2, 5, 1};
    const auto isCurrent = [&present](const Queue::Entry& entry) {
        return present[entry.id.value] == entry.generation;
    };
    EXPECT_EQ(queue.popCurrent(isCurrent)->id, TetId(1));
    EXPECT_EQ(queue.popCurrent(isCurrent)->id, TetId(2));
    EXPECT_FALSE(queue.popCurrent(isCurrent).has_value());
}

TEST(BucketQueue, TakesKeysOfAnyMagnitude)
{
    Queue queue;
    queue.push(TetId(0), 0, 0.0);
    queue.push(TetId(1), 0, std::numeric_limits<double>::denorm_min());
    queue.push(TetId(2), 0, 1e-10);
    queue.push(TetId(3), 0, 1.0);
    queue.push(TetId(4), 0, 1e10);
    queue.push(TetId(5), 0, std::numeric_limits<double>::max());
    queue.push(TetId(6), 0, std::numeric_limits<double>::infinity());
    queue.push(TetId(7), 0, -0.0);
    EXPECT_EQ(drain(queue), (std::vector<std::uint32_t>{5, 6, 4, 3, 2, 0, 1, 7}));
}

TEST(BucketQueue, OrdersWithinTheWidthOfABucket)
{
    // Interleaved pushes and pops, large enough for the compaction of taken entries.
    Random random(11);
    Queue queue;
    std::vector<double> waiting;
    for (int round = 0; round < 10; ++round) {
        for (std::uint32_t i = 0; i < 2000; ++i) {
            const double key = std::exp2(random.between(-3.0, 3.0));
            queue.push(TetId(static_cast<std::uint32_t>(waiting.size())), 0, key);
            waiting.push_back(key);
        }
        double largest = 0.0;
        for (const double key : waiting) largest = std::max(largest, key);
        for (int i = 0; i < 1600; ++i) {
            const auto entry = queue.pop();
            ASSERT_TRUE(entry.has_value());
            ASSERT_EQ(entry->key, waiting[entry->id.value]);
            ASSERT_GE(entry->key, largest * 8.0 / 9.0);
            waiting[entry->id.value] = 0.0;
            if (entry->key == largest) {
                largest = 0.0;
                for (const double key : waiting) largest = std::max(largest, key);
            }
        }
    }
    EXPECT_EQ(queue.size(), 4000u);
}

TEST(BucketQueue, KeepsTheOrderOfInsertionAcrossCompaction)
{
    Queue queue;
    std::uint32_t pushed = 0;
    std::uint32_t taken = 0;
    for (int round = 0; round < 50; ++round) {
        for (int i = 0; i < 300; ++i) queue.push(TetId(pushed++), 0, 1.0);
        for (int i = 0; i < 250; ++i) ASSERT_EQ(queue.pop()->id, TetId(taken++));
    }
    queue.clear();
    EXPECT_FALSE(queue.pop().has_value());
}

#ifndef NDEBUG
TEST(BucketQueueDeathTest, RefusesKeysWithoutAnOrder)
{
    Queue queue;
    EXPECT_DEATH(queue.push(TetId(0), 0, std::nan("")), "broken precondition");
    EXPECT_DEATH(queue.push(TetId(0), 0, -1.0), "broken precondition");
}
#endif

}  // namespace
}  // namespace mesher
