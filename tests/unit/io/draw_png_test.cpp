#include "io/draw_png.h"

#include "io/line_raster.h"
#include "io/mesh_writer.h"
#include "support/sample_meshes.h"
#include "support/temp_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace mesher {
namespace {

constexpr Colour kWhite = {255, 255, 255};
constexpr Colour kBlack = {0, 0, 0};

TEST(LineRaster, DrawsALineWithItsWidthAndSoftEdges)
{
    Image image(20, 20, kWhite);
    drawLine(image, {3.0, 10.5}, {17.0, 10.5}, 1.0, kBlack, 1.0);
    EXPECT_EQ(image.at(10, 10), kBlack);
    EXPECT_EQ(image.at(10, 8), kWhite);
    EXPECT_EQ(image.at(10, 12), kWhite);
    EXPECT_EQ(image.at(1, 10), kWhite);
    drawLine(image, {3.0, 5.0}, {17.0, 5.0}, 1.0, kBlack, 1.0);  // between two rows: both half
    EXPECT_NEAR(image.at(10, 4).red, 128, 1);
    EXPECT_NEAR(image.at(10, 5).red, 128, 1);
}

TEST(LineRaster, DrawsASlantedLineWithoutGaps)
{
    Image image(50, 50, kWhite);
    drawLine(image, {2.0, 3.0}, {47.0, 31.0}, 1.5, kBlack, 1.0);
    for (std::size_t x = 4; x < 45; ++x) {
        int darkest = 255;
        for (std::size_t y = 0; y < 50; ++y) darkest = std::min<int>(darkest, image.at(x, y).red);
        EXPECT_LT(darkest, 60) << x;
    }
}

TEST(LineRaster, LeavesAwayWhatIsOutside)
{
    Image image(10, 10, kWhite);
    drawLine(image, {-1e9, -1e9}, {1e9, 1e9}, 1.0, kBlack, 1.0);
    fillTriangle(image, {{{-1e9, -5.0}, {1e9, -5.0}, {0.0, -1e9}}}, kBlack);
    EXPECT_EQ(image.at(0, 9), kWhite);
    EXPECT_LT(image.at(5, 5).red, 255);
}

TEST(LineRaster, FillsATriangleOfEitherTurn)
{
    for (const bool isTurned : {false, true}) {
        Image image(20, 20, kWhite);
        const Vec2 b = {18.0, 2.0};
        const Vec2 c = {2.0, 18.0};
        fillTriangle(image, {{{2.0, 2.0}, isTurned ? c : b, isTurned ? b : c}}, kBlack);
        EXPECT_EQ(image.at(5, 5), kBlack);
        EXPECT_EQ(image.at(15, 15), kWhite);
        const auto filled = std::count(image.pixels.begin(), image.pixels.end(), kBlack);
        EXPECT_NEAR(static_cast<double>(filled), 128.0, 9.0);
    }
}

TEST(DrawMesh, GivesEachFaceItsColour)
{
    const Result<Image> image = drawMesh(test::twoFaceMesh(2), {400, 1.0, 2.0, {}});
    ASSERT_TRUE(image);
    EXPECT_EQ(image.value().width, 400u);
    EXPECT_NEAR(static_cast<double>(image.value().height), 224.0, 1.0);
    // Inside of a triangle of each face, away from the edges.
    const Colour left = image.value().at(24 + 60, 224 / 2 + 20);
    const Colour right = image.value().at(400 - 24 - 60, 224 / 2 - 20);
    EXPECT_NE(left, kWhite);
    EXPECT_NE(right, kWhite);
    EXPECT_NE(left, right);
    EXPECT_EQ(image.value().at(5, 5), kWhite);
}

TEST(DrawMesh, DrawsTheWindowAskedFor)
{
    const ClassifiedMesh mesh = test::twoFaceMesh(2);
    Box2 all;
    for (const MeshNode& node : mesh.nodes) all.include({node.position.x, node.position.y});
    DrawingOptions options;
    options.width = 400;
    const Result<Image> whole = drawMesh(mesh, options);
    options.window = all;
    EXPECT_EQ(drawMesh(mesh, options).value().pixels, whole.value().pixels);
    // Of the left half alone the picture is twice as high,.
    options.window->high.x = 0.5 * (all.low.x + all.high.x);
    const Result<Image> left = drawMesh(mesh, options);
    ASSERT_TRUE(left);
    EXPECT_EQ(left.value().width, 400u);
    EXPECT_NEAR(static_cast<double>(left.value().height) - 48.0,
                2.0 * (static_cast<double>(whole.value().height) - 48.0), 2.0);
    options.window->high.x = options.window->low.x;
    EXPECT_FALSE(drawMesh(mesh, options));
}

TEST(DrawMesh, RefusesWhatCannotBeDrawn)
{
    EXPECT_FALSE(drawMesh({}));
    EXPECT_FALSE(drawMesh(test::twoFaceMesh(), {10, 1.0, 1.0, {}}));
    EXPECT_FALSE(drawMesh(test::twoFaceMesh(), {1u << 20, 1.0, 1.0, {}}));
}

TEST(DrawMesh, WritesAFileOfThePngFormat)
{
    const test::TempDir folder;
    ASSERT_TRUE(writeMesh(test::twoSolidMesh(3), folder.path() / "m.png"));
    std::ifstream file(folder.path() / "m.png", std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str().substr(0, 16), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
    EXPECT_EQ(text.str().substr(text.str().size() - 8), std::string("IEND\xae\x42\x60\x82", 8));
}

}  // namespace
}  // namespace mesher
