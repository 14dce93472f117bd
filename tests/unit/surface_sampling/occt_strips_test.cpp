#include "brep/occt/model_builder.h"
#include "mesh/region_sides.h"
#include "sizing/uniform_size.h"
#include "surface_sampling/narrow_strips.h"
#include "surface_sampling/sample_surface.h"
#include "surface_sampling/surface_check.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace mesher {
namespace {

constexpr double kSize = 1.5;
constexpr double kStep = 0.02;
constexpr double kDepth = 6.0;

/// A block with a step across its top that is far lower than any size.
TopoDS_Shape steppedBlock()
{
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [x, y] :
         {std::pair{0.0, 0.0}, {8.0, 0.0}, {8.0, 3.0}, {4.0, 3.0}, {4.0, 3.0 + kStep}, {0.0, 3.0 + kStep}})
        outline.Add(gp_Pnt(x, y, 0.0));
    outline.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0.0, 0.0, kDepth))
        .Shape();
}

struct Part
{
    explicit Part(const TopoDS_Shape& shape) : model(*buildModel(shape)), sides(*regionSidesOf(model)) {}

    [[nodiscard]] SurfaceSample sample(double maxTets, double leastSize = 0.0) const
    {
        const UniformSize size(kSize);
        SurfaceSamplingOptions options;
        options.curves.sizes = &size;
        options.facets.sizes = &size;
        options.walls.sides = &sides;
        options.walls.maxStripTets = maxTets;
        options.walls.leastSize = leastSize;
        RunContext context;
        return std::move(*sampleSurface(model, options, context));
    }

    BrepModel model;
    RegionSides sides;
};

TEST(NarrowStrips, TellWhatGoodFacetsOfAStepBringAbout)
{
    const SurfaceSample result = Part(steppedBlock()).sample(1e9);
    ASSERT_EQ(result.counts.surveyedStrips.size(), 1u);
    const SurveyedStrip& strip = result.counts.surveyedStrips.front();
    EXPECT_NEAR(strip.width, kStep, 1e-9);
    EXPECT_NEAR(strip.tets, 80.0 * 2.0 * kDepth / kStep, 8.0 * 2.0 * kDepth / kStep);
    EXPECT_FALSE(strip.isKept);
    EXPECT_EQ(result.counts.refinement.leftOnStrips, 0u);
}

TEST(NarrowStrips, AreLeftWithLongFacetsWhereGoodOnesWouldTakeTooMany)
{
    const Part part(steppedBlock());
    const SurfaceSample good = part.sample(1e9);
    const SurfaceSample flat = part.sample(5000.0);
    ASSERT_EQ(flat.counts.surveyedStrips.size(), 1u);
    EXPECT_TRUE(flat.counts.surveyedStrips.front().isKept);
    EXPECT_LT(5 * flat.counts.facets, good.counts.facets);
    const std::vector<FlatStripFacet> facets = facetsOnStrips(*flat.surface);
    EXPECT_EQ(facets.size(), flat.counts.refinement.leftOnStrips);
    ASSERT_FALSE(facets.empty());
    for (const FlatStripFacet& facet : facets) {
        EXPECT_EQ(facet.face, flat.counts.surveyedStrips.front().face);
        EXPECT_TRUE(flat.surface->isOnFlatRim(facet.facet));
    }
}

TEST(NarrowStrips, ThinnerThanAnythingMayBeAreLeftFlat)
{
    const Part part(steppedBlock());
    EXPECT_FALSE(part.sample(1e9, 0.5 * kStep).counts.surveyedStrips.front().isKept);
    EXPECT_TRUE(part.sample(1e9, 2.0 * kStep).counts.surveyedStrips.front().isKept);
}

/// The bottom of a groove ends a gap: a thin slot is meshed well wherever it is.
TEST(NarrowStrips, AreNotAtTheEndsOfGaps)
{
    const TopoDS_Shape groove =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(4.0, 4.0, 4.0).Shape(),
                        BRepPrimAPI_MakeBox(gp_Pnt(1.0, 2.0, 3.5), 2.0, 0.04, 1.0).Shape())
            .Shape();
    const SurfaceSample result = Part(groove).sample(0.0);
    EXPECT_TRUE(result.counts.surveyedStrips.empty());
    EXPECT_EQ(result.counts.refinement.leftOnStrips, 0u);
}

TEST(NarrowStrips, TheCheapestAreMadeGoodFirst)
{
    std::vector<SurveyedStrip> strips(3);
    strips[0].tets = 700.0;
    strips[1].tets = 200.0;
    strips[2].tets = 400.0;
    keepDearStrips(strips, 650.0, 0.0);
    EXPECT_TRUE(strips[0].isKept);
    EXPECT_FALSE(strips[1].isKept);
    EXPECT_FALSE(strips[2].isKept);
    EXPECT_EQ(strips[0].needed, 1300.0);
}

}  // namespace
}  // namespace mesher
