#include "io/draw_space.h"

#include "io/depth_raster.h"
#include "io/visible_facets.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace mesher {
namespace {

constexpr Colour kWhite = {255, 255, 255};
constexpr Colour kRed = {255, 0, 0};
constexpr Colour kBlue = {0, 0, 255};

RasterTriangle triangleAt(double depth, Colour colour)
{
    RasterTriangle triangle;
    triangle.corner = {Vec3{2.0, 2.0, depth}, {18.0, 2.0, depth}, {2.0, 18.0, depth}};
    triangle.colour = colour;
    return triangle;
}

std::size_t pixelsOf(const Image& image, Colour colour)
{
    return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

std::size_t drawnPixels(const Image& image) { return image.pixels.size() - pixelsOf(image, kWhite); }

TEST(DepthRaster, CoversThePixelsOfATriangleOfEitherTurn)
{
    for (const bool isTurned : {false, true}) {
        DepthRaster raster(20, 20, kWhite);
        RasterTriangle triangle = triangleAt(1.0, kRed);
        if (isTurned) std::swap(triangle.corner[0], triangle.corner[1]);
        raster.draw(triangle);
        EXPECT_EQ(pixelsOf(raster.image(), kRed), 136u);  // centres with x + y <= 20: 16 * 17 / 2
        EXPECT_EQ(raster.image().at(2, 2), kRed);
        EXPECT_EQ(raster.image().at(18, 18), kWhite);
    }
}

TEST(DepthRaster, HidesTheFarTriangleInEitherOrder)
{
    for (const bool isNearFirst : {false, true}) {
        DepthRaster raster(20, 20, kWhite);
        raster.draw(isNearFirst ? triangleAt(2.0, kRed) : triangleAt(1.0, kBlue));
        raster.draw(isNearFirst ? triangleAt(1.0, kBlue) : triangleAt(2.0, kRed));
        EXPECT_EQ(pixelsOf(raster.image(), kRed), 136u) << isNearFirst;
        EXPECT_EQ(pixelsOf(raster.image(), kBlue), 0u) << isNearFirst;
    }
}

TEST(DepthRaster, CutsThroughTrianglesThatCross)
{
    DepthRaster raster(20, 20, kWhite);
    RasterTriangle tilted = triangleAt(0.0, kBlue);
    tilted.corner[1].z = 16.0;  // depth x - 2
    raster.draw(tilted);
    raster.draw(triangleAt(8.0, kRed));
    EXPECT_EQ(raster.image().at(5, 4), kRed);
    EXPECT_EQ(raster.image().at(14, 4), kBlue);
}

TEST(DepthRaster, DrawsTheLineAlongOneEdgeOnly)
{
    DepthRaster raster(20, 20, kWhite);
    RasterTriangle triangle = triangleAt(0.0, kRed);
    triangle.lineWidth = {2.0, 0.0, 0.0};  // along y = 2
    triangle.lineColour[0] = kBlue;
    triangle.lineOpacity[0] = 1.0;
    raster.draw(triangle);
    EXPECT_EQ(raster.image().at(8, 2), kBlue);
    EXPECT_EQ(raster.image().at(8, 3), kBlue);
    EXPECT_EQ(raster.image().at(8, 4), kRed);
    EXPECT_EQ(raster.image().at(2, 8), kRed);
}

TEST(DepthRaster, TakesTheMeanWhereItReduces)
{
    DepthRaster raster(4, 4, {0, 0, 0});
    RasterTriangle first;
    first.corner = {Vec3{0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}, {0.0, 1.2, 0.0}};  // one pixel of the first four
    first.colour = {200, 100, 40};
    raster.draw(first);
    const Image small = raster.reduced(2);
    ASSERT_EQ(small.width, 2u);
    EXPECT_EQ(small.at(0, 0), (Colour{50, 25, 10}));
    EXPECT_EQ(small.at(1, 1), (Colour{0, 0, 0}));
}

TEST(VisibleFacets, OfACutAreTheSurfaceOfWholeElements)
{
    const ClassifiedMesh mesh = test::twoSolidMesh(2);  // 0.4 x 0.2 x 0.2, the solids meet at x = 0.2
    const std::vector<VisibleFacet> cut = cutSurfaceOf(mesh, {0, 0.2}, {1.0, 0.0, 0.0});
    // Of the first solid alone: six sides of 2 x 2 cells, two triangles a cell, all on faces of the model.
    EXPECT_EQ(cut.size(), 48u);
    for (const VisibleFacet& facet : cut) {
        EXPECT_EQ(facet.entity.dimension, 2);
        for (const NodeId node : facet.node) EXPECT_LE(mesh.nodes[node].position.x, 0.2 + 1e-12);
    }
    // Through the middle of the second one there are sides of its tetrahedra, from whichever side it is seen.
    for (const double eye : {1.0, -1.0}) {
        const std::vector<VisibleFacet> open = cutSurfaceOf(mesh, {0, 0.3}, {eye, 0.0, 0.0});
        const auto inner = std::count_if(open.begin(), open.end(), [](const VisibleFacet& f) {
            return f.entity == EntityRef{3, 1};
        });
        EXPECT_GE(inner, 8) << eye;
    }
}

TEST(VisibleFacets, AreTheSidesOfTetrahedraWithoutTriangles)
{
    ClassifiedMesh mesh = test::twoSolidMesh(2);
    mesh.triangles.clear();
    EXPECT_EQ(surfaceOf(mesh).size(), 2u * (2 * 4 + 2 * 8 + 2 * 8) / 2 * 2);
}

TEST(VisibleFacets, CutAcrossTheShorterAxisThroughTheMiddle)
{
    const ClassifiedMesh mesh = test::twoSolidMesh(2);
    EXPECT_EQ(cutPlaneOf(mesh, {}).axis, 1u);
    EXPECT_DOUBLE_EQ(cutPlaneOf(mesh, {}).at, 0.1);
    DrawingOptions options;
    options.cutAxis = 2;
    options.cutAt = 0.15;
    EXPECT_EQ(cutPlaneOf(mesh, options).axis, 2u);
    EXPECT_DOUBLE_EQ(cutPlaneOf(mesh, options).at, 0.15);
}

TEST(DrawInSpace, ShowsSurfaceAndCutBesideEachOther)
{
    DrawingOptions options;
    options.width = 401;
    const ClassifiedMesh mesh = test::twoSolidMesh(2);
    const Image both = drawInSpace(mesh, options);
    EXPECT_EQ(both.width, 401u);
    options.width = 200;
    options.part = DrawnPart::Surface;
    const Image surface = drawInSpace(mesh, options);
    options.part = DrawnPart::Cut;
    const Image cut = drawInSpace(mesh, options);
    ASSERT_EQ(both.height, surface.height);
    EXPECT_EQ(both.at(100, both.height / 2), surface.at(100, both.height / 2));
    EXPECT_EQ(drawnPixels(both), drawnPixels(surface) + drawnPixels(cut));
    EXPECT_LT(drawnPixels(cut), drawnPixels(surface));
    EXPECT_GT(drawnPixels(cut), drawnPixels(surface) / 4);
}

TEST(DrawInSpace, ShowsTheWholeOutlineOfABox)
{
    DrawingOptions options;
    options.width = 400;
    options.part = DrawnPart::Surface;
    const Image image = drawInSpace(test::twoSolidMesh(2), options);
    // Seen along (1, -1.2, 0.9), the sides of 0.2 x 0.2, 0.4 x 0.2 and 0.4 x 0.2 cover what their normals say, in a
    // picture as wide as the box's outline.
    const double length = std::sqrt(1.0 + 1.44 + 0.81);
    const double area = (0.04 * 1.0 + 0.08 * 1.2 + 0.08 * 0.9) / length;
    const double outline = (0.4 * 1.2 + 0.2 * 1.0) / std::hypot(1.0, 1.2);
    const double scale = (400.0 - 48.0) / outline;
    EXPECT_NEAR(static_cast<double>(drawnPixels(image)), area * scale * scale, 1500.0);
}

TEST(DrawInSpace, MakesTheSamePictureAgainAndOfTrianglesInAnyOrder)
{
    ClassifiedMesh mesh = test::twoSolidMesh(3);
    DrawingOptions options;
    options.width = 400;
    options.part = DrawnPart::Surface;
    const Image first = drawInSpace(mesh, options);
    EXPECT_EQ(drawInSpace(mesh, options).pixels, first.pixels);
    std::reverse(mesh.tets.begin(), mesh.tets.end());
    options.part = DrawnPart::Cut;
    const Image cut = drawInSpace(mesh, options);
    std::reverse(mesh.tets.begin(), mesh.tets.end());
    EXPECT_EQ(drawInSpace(mesh, options).pixels, cut.pixels);
}

TEST(DrawInSpace, HidesTheFarSides)
{
    // The eye sees the faces at the largest x, the least y and the largest z: of an opaque box of which each face has a
    // colour of its own no other colour is on the picture without edges.
    ClassifiedMesh mesh = test::gridMesh({{0, 2}, {0, 2}, {0, 2}, 0.1});
    DrawingOptions options;
    options.width = 400;
    options.part = DrawnPart::Surface;
    options.edgeWidth = 0.0;
    options.boundaryWidth = 0.0;
    const Image image = drawInSpace(mesh, options);
    std::set<std::tuple<int, int, int>> colours;
    for (std::size_t y = 0; y < image.height; ++y) {
        for (std::size_t x = 1; x + 1 < image.width; ++x) {
            const Colour& pixel = image.at(x, y);
            const bool isInside = image.at(x - 1, y) == pixel && image.at(x + 1, y) == pixel;
            if (isInside && !(pixel == kWhite)) colours.emplace(pixel.red, pixel.green, pixel.blue);
        }
    }
    EXPECT_EQ(colours.size(), 3u);
}

}  // namespace
}  // namespace mesher
