#include "base/id_vector.h"
#include "base/ids.h"

#include <gtest/gtest.h>

#include <memory>
#include <type_traits>

namespace mesher {
namespace {

static_assert(!std::is_convertible_v<std::uint32_t, VertexId>, "a bare number is no id");
static_assert(!std::is_convertible_v<VertexId, TetId>, "one kind of id is no other");
static_assert(!std::is_constructible_v<TetId, VertexId>, "one kind of id is no other");
static_assert(sizeof(TetId) == 4);

TEST(Id, IsInvalidByDefaultAndOrderedByItsIndex)
{
    EXPECT_FALSE(VertexId().isValid());
    EXPECT_TRUE(VertexId(0).isValid());
    EXPECT_FALSE(VertexId(VertexId::kInvalid).isValid());
    EXPECT_LT(VertexId(3), VertexId(4));
    EXPECT_EQ(VertexId(3), VertexId(3));
    EXPECT_LT(VertexId(3), VertexId());
}

TEST(IdVector, HandsOutIdsInOrder)
{
    IdVector<TetId, int> values;
    EXPECT_TRUE(values.empty());
    const int seven = 7;
    EXPECT_EQ(values.push_back(seven), TetId(0));
    EXPECT_EQ(values.push_back(8), TetId(1));
    values[TetId(0)] = 9;
    EXPECT_EQ(values[TetId(0)], 9);
    EXPECT_EQ(std::as_const(values)[TetId(1)], 8);
    values.resize(4, 5);
    EXPECT_EQ(values[TetId(3)], 5);
    EXPECT_EQ(values.size(), 4u);
}

TEST(IdVector, TakesItemsThatCanOnlyBeMoved)
{
    IdVector<TetId, std::unique_ptr<int>> values;
    const TetId id = values.push_back(std::make_unique<int>(3));
    EXPECT_EQ(*values[id], 3);
}

#ifndef NDEBUG
TEST(IdVectorDeathTest, RefusesIdsBeyondItsEnd)
{
    IdVector<TetId, int> values(3);
    EXPECT_DEATH(static_cast<void>(values[TetId(3)]), "broken precondition");
    EXPECT_DEATH(static_cast<void>(std::as_const(values)[TetId()]), "broken precondition");
}
#endif

}  // namespace
}  // namespace mesher
