#include "refinement/thin_walls.h"

#include "sizing/uniform_size.h"
#include "unit/refinement/refinement_fixture.h"

#include <cmath>

namespace mesher::test {
namespace {

constexpr double kThickness = 0.05;
constexpr double kSize = 1.0;

/// With facets about 1 large on its two faces.
SampledSolid plate() { return sampledPlate(8.0, kThickness, 8); }

RefinedVolume refinePlate(SampledSolid& solid, double maxWallTets)
{
    const UniformSize field(kSize);
    RefineVolumeOptions options;
    options.sizing.field = &field;
    options.sizing.usesLocalFeatureSize = false;
    options.maxWallTets = maxWallTets;
    return refine(solid, options);
}

TEST(ThinWalls, AreFoundBetweenTheFacesOfAPlateAndNotInACube)
{
    SampledSolid solid = plate();
    ThinWalls walls(solid.tetrahedralization);
    walls.find(solid.splitter->mesh(), 1e6);
    ASSERT_EQ(walls.walls().size(), 1u);
    const ThinWall& wall = walls.walls().front();
    EXPECT_EQ(wall.face[0], BrepFaceId(4u));
    EXPECT_EQ(wall.face[1], BrepFaceId(5u));
    EXPECT_NEAR(wall.thickness, kThickness, 1e-12);
    EXPECT_FALSE(wall.isKept);

    SampledSolid cube = sampledBox({1, 1, 1}, 4);
    ThinWalls none(cube.tetrahedralization);
    none.find(cube.splitter->mesh(), 0.0);
    for (const ThinWall& thick : none.walls()) EXPECT_FALSE(thick.isKept);
}

TEST(ThinWalls, TakeAboutAsManyTetrahedraAsEstimated)
{
    SampledSolid solid = plate();
    const RefinedVolume result = refinePlate(solid, 1e6);
    ASSERT_EQ(result.walls.size(), 1u);
    EXPECT_TRUE(result.left.empty());
    EXPECT_GE(dihedralRange(solid).least, 18.0);
    EXPECT_GT(static_cast<double>(result.tets), 0.2 * result.walls.front().tets);
    EXPECT_LT(static_cast<double>(result.tets), 5.0 * result.walls.front().tets);
}

TEST(ThinWalls, AreKeptFlatWhereTheyWouldTakeTooMany)
{
    SampledSolid solid = plate();
    SampledSolid good = plate();
    const std::uint64_t whole = refinePlate(good, 1e6).tets;
    const RefinedVolume result = refinePlate(solid, 1000.0);
    EXPECT_TRUE(isSound(solid));
    EXPECT_EQ(result.stopReason, StopReason::CannotImprove);
    EXPECT_LT(result.tets, whole / 2);
    EXPECT_EQ(countNonDelaunayFaces(solid.tetrahedralization.mesh(), DelaunayPart::Inside), 0u);
    ASSERT_FALSE(result.places.empty());
    const LeftPlace3d& place = result.places.front();
    EXPECT_EQ(place.reason, LeftReason3d::ThinWall);
    EXPECT_EQ(place.entity[0], (EntityRef{2, 4}));
    EXPECT_EQ(place.entity[1], (EntityRef{2, 5}));
    // Each tetrahedron that is bad is told.
    std::size_t bad = 0;
    for (const TetId tet : meshedTets(solid)) {
        const auto angles = dihedralAngles(cornersOf(solid, tet));
        const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
        bad += *least < 18.6 || *most > 155.1 ? 1u : 0u;
    }
    EXPECT_GT(bad, 0u);
    EXPECT_GE(result.left.size(), bad);
}

TEST(ThinWalls, StayAsTheyAreInASecondRun)
{
    SampledSolid solid = plate();
    refinePlate(solid, 1000.0);
    const std::size_t tets = meshedTets(solid).size();
    const RefinedVolume again = refinePlate(solid, 1000.0);
    EXPECT_LE(again.tets, tets + tets / 20);
}

}  // namespace
}  // namespace mesher::test
