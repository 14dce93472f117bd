#include "base/assert.h"

#include <gtest/gtest.h>

namespace mesher {
namespace {

TEST(AssertDeathTest, FailureNamesKindConditionAndPlace)
{
    EXPECT_DEATH(detail::assertionFailed("invariant", "a < b", "file.cpp", 12),
                 "file.cpp:12: broken invariant: a < b");
}

TEST(AssertDeathTest, ConditionsAreEvaluatedInDebugBuildsOnly)
{
    int evaluations = 0;
    MESHER_INVARIANT(++evaluations > 0);
    MESHER_PRECONDITION(++evaluations > 0);
#ifdef NDEBUG
    EXPECT_EQ(evaluations, 0);
    MESHER_INVARIANT(false);
#else
    EXPECT_EQ(evaluations, 2);
    EXPECT_DEATH(MESHER_INVARIANT(evaluations == 0), "broken invariant: evaluations == 0");
    EXPECT_DEATH(MESHER_PRECONDITION(evaluations == 0), "broken precondition: evaluations == 0");
#endif
}

}  // namespace
}  // namespace mesher
