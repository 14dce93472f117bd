#include "surface_sampling/wall_survey.h"

#include "brep/analytic/solids.h"
#include "mesh/region_sides.h"
#include "sizing/uniform_size.h"
#include "surface_sampling/sample_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mesher::test {
namespace {

constexpr double kThickness = 0.05;
constexpr double kSide = 3.0;

SurfaceSample sample(const BrepModel& model, const RegionSides& sides, double maxTets, double leastSize = 0.0)
{
    const UniformSize size(0.5);
    SurfaceSamplingOptions options;
    options.facets.sizes = &size;
    options.curves.sizes = &size;
    options.walls.sides = &sides;
    options.walls.maxTets = maxTets;
    options.walls.leastSize = leastSize;
    RunContext context;
    return std::move(*sampleSurface(model, options, context));
}

struct Plate
{
    BrepModel model = *makeBox({}, {kSide, kSide, kThickness});
    RegionSides sides = *regionSidesOf(model);
};

TEST(WallSurvey, TellsWhatGoodTetrahedraInAPlateWouldBe)
{
    const Plate plate;
    const SurfaceSample result = sample(plate.model, plate.sides, 1e6);
    ASSERT_EQ(result.counts.surveyedWalls.size(), 1u);
    const SurveyedWall& wall = result.counts.surveyedWalls.front();
    EXPECT_EQ(wall.sides, WallSides::of(BrepFaceId(4u), BrepFaceId(5u), RegionId(1u)));
    EXPECT_NEAR(wall.thickness, kThickness, 1e-12);
    const double inside = 2.0 * 2.0 * kSide * kSide / (kThickness * kThickness);
    EXPECT_GT(wall.tets, inside);
    EXPECT_LT(wall.tets, 2.0 * inside);
    EXPECT_FALSE(wall.isKept);
}

/// One decision for both: good rims of a flat wall are dear and of no use.
TEST(WallSurvey, KeepsTheRimsOfAWallAsFlatAsTheWall)
{
    const Plate plate;
    const SurfaceSample good = sample(plate.model, plate.sides, 1e6);
    EXPECT_EQ(good.counts.refinement.leftOnRims, 0u);
    // Enough for the rims, not for the wall.
    const SurfaceSample flat = sample(plate.model, plate.sides, 8000.0);
    ASSERT_EQ(flat.counts.surveyedWalls.size(), 1u);
    EXPECT_TRUE(flat.counts.surveyedWalls.front().isKept);
    EXPECT_EQ(flat.counts.surveyedWalls.front().rims.size(), 4u);
    EXPECT_GT(flat.counts.refinement.leftOnRims, 0u);
    EXPECT_LT(4 * flat.counts.facets, good.counts.facets);
}

TEST(WallSurvey, KeepsWallsThatAreThinnerThanAnythingMayBe)
{
    const Plate plate;
    EXPECT_FALSE(sample(plate.model, plate.sides, 1e6, 0.5 * kThickness).counts.surveyedWalls.front().isKept);
    EXPECT_TRUE(sample(plate.model, plate.sides, 1e6, 2.0 * kThickness).counts.surveyedWalls.front().isKept);
}

TEST(WallSurvey, MakesTheCheapestGoodFirst)
{
    std::vector<SurveyedWall> walls(3);
    walls[0].tets = 700.0;
    walls[1].tets = 200.0;
    walls[2].tets = 400.0;
    keepDearWalls(walls, 650.0, 0.0);
    EXPECT_TRUE(walls[0].isKept);
    EXPECT_FALSE(walls[1].isKept);
    EXPECT_FALSE(walls[2].isKept);
    EXPECT_EQ(walls[0].needed, 1300.0);
}

TEST(WallSurvey, FindsNoneInACube)
{
    const BrepModel cube = *makeBox({}, {2.0, 2.0, 2.0});
    const RegionSides sides = *regionSidesOf(cube);
    EXPECT_TRUE(sample(cube, sides, 0.0).counts.surveyedWalls.empty());
}

/// On the sides of the plate, and not on its rims.
TEST(WallSurvey, NamesTheFacetsOfFlatWalls)
{
    const Plate plate;
    const SurfaceSample flat = sample(plate.model, plate.sides, 0.0);
    RunContext context;
    const std::vector<FlatWallFacet> facets =
        facetsOnWalls(*flat.surface, plate.sides, keptOf(flat.counts.surveyedWalls), context);
    const auto& all = flat.surface->mesh().facets;
    const auto onSides = std::count_if(all.begin(), all.end(), [](const SurfaceFacet& facet) {
        return facet.isAlive() && facet.face.value >= 4u;
    });
    EXPECT_EQ(facets.size(), static_cast<std::size_t>(onSides));
}

}  // namespace
}  // namespace mesher::test
