#include "io/read_size_points.h"

#include <gtest/gtest.h>

namespace mesher {
namespace {

TEST(ReadSizePoints, TakesALineForEachPoint)
{
    const auto points =
        readSizePointsText("# places\n1 2 3 0.5\n\n  -1e2\t+4.5 0 7 # the last one\r\n0 0 0 1e-3");
    ASSERT_TRUE(points) << describe(points.error());
    ASSERT_EQ(points->size(), 3u);
    EXPECT_EQ((*points)[0].position, (Vec3{1.0, 2.0, 3.0}));
    EXPECT_EQ((*points)[0].size, 0.5);
    EXPECT_EQ((*points)[1].position, (Vec3{-100.0, 4.5, 0.0}));
    EXPECT_EQ((*points)[1].size, 7.0);
    EXPECT_EQ((*points)[2].size, 1e-3);
}

TEST(ReadSizePoints, RefusesOtherLinesByTheirNumber)
{
    for (const auto& [text, message] : {std::pair{"1 2 3 4\n5 6 7\n8", "line 2: four numbers"},
                                        {"1 2 3 4 5", "line 1: four numbers"},
                                        {"# c\n1,2,3,4", "line 2: four numbers"},
                                        {"1 2 x 4", "line 1: four numbers"},
                                        {"1 2 3 0", "line 1: the size"},
                                        {"1 2 3 -4", "line 1: the size"},
                                        {"1 2 3 nan", "line 1: the size"},
                                        {"1 2 3 inf", "line 1: the size"},
                                        {"1 inf 3 1", "line 1: the place"},
                                        {"1 2 3 1e999", "line 1: four numbers"},
                                        {"", "without a point"},
                                        {"\n# only this\n", "without a point"}}) {
        const auto points = readSizePointsText(text);
        ASSERT_FALSE(points) << text;
        EXPECT_EQ(points.error().code, ErrorCode::Unreadable);
        EXPECT_NE(points.error().message.find(message), std::string::npos) << points.error().message;
        EXPECT_FALSE(points.error().remedy.empty());
    }
}

}  // namespace
}  // namespace mesher
