#include "base/error.h"

#include <gtest/gtest.h>

#include <set>

namespace mesher {
namespace {

TEST(Error, IsDescribedAsOneSentenceWithEntityPointAndRemedy)
{
    const Error error{ErrorCode::IntersectingConstraints, "two edges cross", "Face6", Vec3{1.0, -2.5, 1e-7},
                      "repair the sketch"};
    EXPECT_EQ(describe(error), "Face6 at (1, -2.5, 1e-07): two edges cross; repair the sketch.");
}

TEST(Error, LeavesOutWhatIsUnknown)
{
    EXPECT_EQ(describe({ErrorCode::Unreadable, "no such file", {}, {}, {}}), "no such file.");
    EXPECT_EQ(describe({ErrorCode::Unreadable, "no such file", "a.bin", {}, {}}), "a.bin: no such file.");
    EXPECT_EQ(describe({ErrorCode::OutOfRange, "too large", {}, Vec3{1, 2, 3}, {}}),
              "at (1, 2, 3): too large.");
}

TEST(Error, FallsBackToTheNameOfTheCodeWithoutAMessage)
{
    EXPECT_EQ(describe({ErrorCode::DegenerateInput, {}, {}, {}, {}}), "degenerate input.");
}

TEST(Error, WritesCoordinatesThatReadBackExactly)
{
    const std::string text = describe({ErrorCode::OutOfRange, "x", {}, Vec3{0.1, 1.0 / 3.0, 0.0}, {}});
    EXPECT_EQ(text, "at (0.1, 0.3333333333333333, 0): x.");
}

TEST(Error, CodesHaveDistinctNames)
{
    std::set<std::string_view> names;
    const int last = static_cast<int>(ErrorCode::Unwritable);
    for (int code = 0; code <= last; ++code) names.insert(nameOf(static_cast<ErrorCode>(code)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(last + 1));
    EXPECT_FALSE(names.contains(""));
}

}  // namespace
}  // namespace mesher
