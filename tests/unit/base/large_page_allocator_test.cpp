#include "base/id_vector.h"
#include "base/ids.h"
#include "base/large_page_allocator.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <vector>

namespace mesher {
namespace {

struct alignas(32) Record
{
    double value[4];
};

bool isAligned(const void* memory, std::uintptr_t to)
{
    return reinterpret_cast<std::uintptr_t>(memory) % to == 0;
}

TEST(LargePageAllocator, AlignsSmallArraysForTheirElements)
{
    std::vector<Record, LargePageAllocator<Record>> records(3);
    EXPECT_TRUE(isAligned(records.data(), alignof(Record)));
}

TEST(LargePageAllocator, AlignsLargeArraysToLargePages)
{
    const std::size_t count = detail::kLargeArrayBytes / sizeof(Record);
    std::vector<Record, LargePageAllocator<Record>> records(count);
    EXPECT_TRUE(isAligned(records.data(), std::uintptr_t{2} << 20));
}

TEST(LargePageAllocator, KeepsTheElementsWhenAnArrayGrowsLarge)
{
    IdVector<VertexId, std::uint64_t> items;
    const std::uint32_t count = 2 * detail::kLargeArrayBytes / sizeof(std::uint64_t) + 17;
    for (std::uint32_t i = 0; i < count; ++i) items.push_back(i * std::uint64_t{3});
    for (std::uint32_t i = 0; i < count; i += 1013) ASSERT_EQ(items[VertexId(i)], i * std::uint64_t{3});
    EXPECT_EQ(items[VertexId(count - 1)], (count - 1) * std::uint64_t{3});
}

TEST(LargePageAllocator, RefusesACountWhoseBytesOverflow)
{
    LargePageAllocator<Record> allocator;
    EXPECT_THROW(static_cast<void>(allocator.allocate(static_cast<std::size_t>(-1) / 16)),
                 std::bad_array_new_length);
}

}  // namespace
}  // namespace mesher
