#include "base/budget.h"

#include <gtest/gtest.h>

#include <set>

namespace mesher {
namespace {

TEST(Budget, LimitsNothingByDefault)
{
    RunContext context;
    Budget budget({}, context);
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(budget.allows({1'000'000'000, 1'000'000'000}));
    EXPECT_EQ(budget.operations(), 1000u);
    EXPECT_FALSE(budget.exhausted().has_value());
    EXPECT_EQ(budget.stopReason(), StopReason::Done);
    EXPECT_EQ(budget.stopReason(StopReason::CannotImprove), StopReason::CannotImprove);
}

TEST(Budget, AllowsExactlyTheGivenNumberOfOperations)
{
    RunContext context;
    BudgetLimits limits;
    limits.maxOperations = 3;
    Budget budget(limits, context);
    int allowed = 0;
    while (budget.allows()) ++allowed;
    EXPECT_EQ(allowed, 3);
    EXPECT_EQ(budget.operations(), 3u);
    EXPECT_EQ(budget.stopReason(StopReason::CannotImprove), StopReason::OperationLimit);
}

TEST(Budget, StopsAtTheVertexAndElementLimits)
{
    RunContext context;
    BudgetLimits limits;
    limits.maxVertices = 10;
    limits.maxElements = 50;
    Budget byVertices(limits, context);
    EXPECT_TRUE(byVertices.allows({9, 49}));
    EXPECT_FALSE(byVertices.allows({10, 49}));
    EXPECT_EQ(byVertices.exhausted(), StopReason::VertexLimit);
    Budget byElements(limits, context);
    EXPECT_FALSE(byElements.allows({9, 50}));
    EXPECT_EQ(byElements.exhausted(), StopReason::ElementLimit);
}

TEST(Budget, StopsWhenTheTimeIsUp)
{
    RunContext ample;
    ample.limitTime(86'400.0);
    EXPECT_TRUE(Budget({}, ample).allows());
    RunContext spent;
    spent.limitTime(0.0);
    Budget budget({}, spent);
    EXPECT_FALSE(budget.allows());
    EXPECT_EQ(budget.exhausted(), StopReason::TimeLimit);
    const TimeLimitPause pause(spent);
    EXPECT_FALSE(budget.allows());
    EXPECT_TRUE(Budget({}, spent).allows());
}

TEST(Budget, StopsWhenTheRunIsCancelled)
{
    RunContext context;
    Budget budget({}, context);
    EXPECT_TRUE(budget.allows());
    context.requestCancel();
    EXPECT_FALSE(budget.allows());
    EXPECT_EQ(budget.exhausted(), StopReason::Cancelled);
}

TEST(Budget, KeepsItsFirstReason)
{
    RunContext context;
    BudgetLimits limits;
    limits.maxVertices = 5;
    Budget budget(limits, context);
    EXPECT_FALSE(budget.allows({5, 0}));
    context.requestCancel();
    EXPECT_FALSE(budget.allows({0, 0}));
    EXPECT_EQ(budget.exhausted(), StopReason::VertexLimit);
    EXPECT_EQ(budget.operations(), 0u);
}

TEST(StopReason, NamesAreDistinct)
{
    std::set<std::string_view> names;
    const int last = static_cast<int>(StopReason::Cancelled);
    for (int reason = 0; reason <= last; ++reason) names.insert(nameOf(static_cast<StopReason>(reason)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(last + 1));
    EXPECT_EQ(nameOf(StopReason::CannotImprove), "cannot_improve");
}

}  // namespace
}  // namespace mesher
