#include "base/indexed_map.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <list>
#include <memory>
#include <vector>

namespace mesher {
namespace {

template <class Map>
auto keysOf(const Map& map)
{
    std::vector<std::remove_cvref_t<decltype((*map.begin()).key)>> keys;
    for (const auto item : map) keys.push_back(item.key);
    return keys;
}

TEST(IndexedMap, FindsWhatWasInserted)
{
    IndexedMap<VertexId, int> map;
    EXPECT_TRUE(map.empty());
    EXPECT_EQ(map.find(VertexId(1)), nullptr);
    EXPECT_FALSE(map.erase(VertexId(1)));
    EXPECT_TRUE(map.insert(VertexId(1), 10).second);
    const auto [value, isNew] = map.insert(VertexId(1), 20);
    EXPECT_FALSE(isNew);
    EXPECT_EQ(*value, 10);
    map.insertOrAssign(VertexId(1), 30);
    map.insertOrAssign(VertexId(2), 40);
    EXPECT_EQ(*map.find(VertexId(1)), 30);
    EXPECT_EQ(map[VertexId(2)], 40);
    EXPECT_EQ(map[VertexId(3)], 0);
    EXPECT_EQ(map.size(), 3u);
}

TEST(IndexedMap, IsWalkedInTheOrderOfInsertion)
{
    IndexedMap<int, int> map;
    for (int i = 0; i < 100; ++i) map.insert((i * 37) % 101, i);
    map.erase((50 * 37) % 101);
    map.insert((50 * 37) % 101, 50);
    std::vector<int> expected;
    for (int i = 0; i < 100; ++i) {
        if (i != 50) expected.push_back((i * 37) % 101);
    }
    expected.push_back((50 * 37) % 101);
    EXPECT_EQ(keysOf(map), expected);
}

TEST(IndexedMap, LetsValuesBeChangedInAWalk)
{
    IndexedMap<int, int> map;
    for (int i = 0; i < 10; ++i) map.insert(i, i);
    for (auto item : map) item.value *= 2;
    EXPECT_EQ(*map.find(7), 14);
}

TEST(IndexedMap, TakesPairsAndArraysOfIdsAsKeys)
{
    IndexedMap<std::pair<VertexId, VertexId>, int> edges;
    edges.insert(unorderedPair(VertexId(5), VertexId(2)), 1);
    EXPECT_TRUE(edges.contains(unorderedPair(VertexId(2), VertexId(5))));
    EXPECT_FALSE(edges.contains({VertexId(5), VertexId(2)}));

    IndexedMap<std::array<std::uint32_t, 3>, int> facets;
    facets.insert({1, 2, 3}, 4);
    EXPECT_TRUE(facets.contains({1, 2, 3}));
    EXPECT_FALSE(facets.contains({3, 2, 1}));
}

TEST(IndexedMap, ReleasesAnErasedValueAtOnce)
{
    IndexedMap<int, std::shared_ptr<int>> map;
    const auto shared = std::make_shared<int>(1);
    map.insert(1, shared);
    EXPECT_EQ(shared.use_count(), 2);
    map.erase(1);
    EXPECT_EQ(shared.use_count(), 1);
}

TEST(IndexedMap, KeepsPointersAfterReserve)
{
    IndexedMap<int, int> map;
    map.reserve(1000);
    const int* first = map.insert(0, 5).first;
    for (int i = 1; i < 1000; ++i) map.insert(i, i);
    EXPECT_EQ(map.find(0), first);
}

/// The same calls on a list that is searched from end to end.
class ListedMap
{
public:
    bool insert(std::uint32_t key, int value)
    {
        if (find(key) != items_.end()) return false;
        items_.emplace_back(key, value);
        return true;
    }
    bool erase(std::uint32_t key)
    {
        const auto at = find(key);
        if (at == items_.end()) return false;
        items_.erase(at);
        return true;
    }
    [[nodiscard]] const std::list<std::pair<std::uint32_t, int>>& items() const { return items_; }

private:
    std::list<std::pair<std::uint32_t, int>>::iterator find(std::uint32_t key)
    {
        return std::find_if(items_.begin(), items_.end(),
                            [key](const auto& item) { return item.first == key; });
    }

    std::list<std::pair<std::uint32_t, int>> items_;
};

TEST(IndexedMap, AgreesWithASearchedListUnderRandomCalls)
{
    // Few distinct keys make long probe runs with gaps; keys 2^20 apart collide in a masked table.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        IndexedMap<std::uint32_t, int> map;
        ListedMap listed;
        for (int step = 0; step < 2000; ++step) {
            const std::uint32_t key = random.below(60) << (seed % 2 == 0 ? 20 : 0);
            if (random.below(5) < 3) {
                ASSERT_EQ(map.insert(key, step).second, listed.insert(key, step)) << "seed " << seed;
            } else {
                ASSERT_EQ(map.erase(key), listed.erase(key)) << "seed " << seed;
            }
            ASSERT_EQ(map.size(), listed.items().size());
        }
        std::vector<std::pair<std::uint32_t, int>> walked;
        for (const auto item : map) walked.emplace_back(item.key, item.value);
        EXPECT_TRUE(std::equal(walked.begin(), walked.end(), listed.items().begin(), listed.items().end()));
        for (const auto& [key, value] : listed.items()) ASSERT_EQ(*map.find(key), value);
    }
}

}  // namespace
}  // namespace mesher
