#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace mesher {
namespace {

Error someError() { return {ErrorCode::OutOfRange, "too large", "point 3", {}, {}}; }

TEST(Result, HoldsAValue)
{
    Result<std::string> result = std::string("text");
    ASSERT_TRUE(result.hasValue());
    EXPECT_TRUE(static_cast<bool>(result));
    EXPECT_EQ(*result, "text");
    EXPECT_EQ(result->size(), 4u);
    result.value() += "s";
    EXPECT_EQ(result.value(), "texts");
}

TEST(Result, HoldsAnError)
{
    const Result<int> result = someError();
    EXPECT_FALSE(result.hasValue());
    EXPECT_FALSE(static_cast<bool>(result));
    EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(result.error().entity, "point 3");
}

TEST(Result, GivesAwayValuesThatCanOnlyBeMoved)
{
    Result<std::unique_ptr<int>> result = std::make_unique<int>(7);
    const std::unique_ptr<int> taken = *std::move(result);
    EXPECT_EQ(*taken, 7);
}

TEST(Result, ChainsStepsUntilTheFirstError)
{
    int stepsRun = 0;
    const auto half = [&stepsRun](int number) -> Result<int> {
        ++stepsRun;
        if (number % 2 != 0) return someError();
        return number / 2;
    };
    const Result<int> reached = Result<int>(12).andThen(half).andThen(half);
    ASSERT_TRUE(reached.hasValue());
    EXPECT_EQ(*reached, 3);
    EXPECT_EQ(stepsRun, 2);

    const Result<int> stopped = Result<int>(6).andThen(half).andThen(half).andThen(half);
    ASSERT_FALSE(stopped.hasValue());
    EXPECT_EQ(stopped.error().message, "too large");
    EXPECT_EQ(stepsRun, 4);
}

TEST(Result, OfNothingIsSuccessOrAnError)
{
    const Result<void> success;
    EXPECT_TRUE(success.hasValue());
    const Result<void> failure = someError();
    ASSERT_FALSE(failure.hasValue());
    EXPECT_EQ(failure.error().message, "too large");
}

#ifndef NDEBUG
TEST(ResultDeathTest, RefusesToReadWhatIsNotThere)
{
    const Result<int> failure = someError();
    EXPECT_DEATH(static_cast<void>(failure.value()), "broken precondition: hasValue");
    const Result<int> success = 1;
    EXPECT_DEATH(static_cast<void>(success.error()), "broken precondition: !hasValue");
    const Result<void> nothing;
    EXPECT_DEATH(static_cast<void>(nothing.error()), "broken precondition: !hasValue");
}
#endif

}  // namespace
}  // namespace mesher
