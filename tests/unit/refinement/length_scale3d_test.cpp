#include "refinement/length_scale3d.h"

#include "sizing/uniform_size.h"
#include "unit/refinement/refinement_fixture.h"

namespace mesher::test {
namespace {

TEST(LengthScale3d, OfACubeIsItsSide)
{
    SampledSolid box = sampledBox({1, 1, 1}, 1);
    LengthScale3d scale(box.tetrahedralization, {});
    scale.setInitial();
    // A corner is sqrt(1/2) away from the diagonals of its faces, which are sides of facets.
    for (const VertexId v : liveVertices(box.tetrahedralization.mesh())) {
        EXPECT_GE(scale.size(v), std::sqrt(0.5) - 1e-12);
        EXPECT_LE(scale.size(v), 1.0);
    }
}

TEST(LengthScale3d, SeesTheOppositeSideOfAThinPlate)
{
    SampledSolid plate = sampledBox({1, 1, 0.05}, 4);
    LengthScale3d scale(plate.tetrahedralization, {});
    scale.setInitial();
    for (const VertexId v : liveVertices(plate.tetrahedralization.mesh()))
        EXPECT_LE(scale.size(v), 0.05 + 1e-12);
}

TEST(LengthScale3d, GrowsNoFasterThanTheGradingAllows)
{
    SampledSolid solid = sampledBox({8, 1, 0.2}, 3);
    VolumeSizing sizing;
    sizing.grading = 4.0;
    sizing.refinement = 2.0;
    LengthScale3d scale(solid.tetrahedralization, sizing);
    scale.setInitial();
    const Triangulation3d& mesh = solid.tetrahedralization.mesh();
    for (const TetId tet : meshedTets(solid)) {
        for (const VertexId a : mesh.tet(tet).vertex) {
            for (const VertexId b : mesh.tet(tet).vertex) {
                EXPECT_LE(scale.size(a),
                          scale.size(b) + length(mesh.position(a) - mesh.position(b)) / 4.0 + 1e-12);
            }
        }
    }
}

TEST(LengthScale3d, TakesTheUsersWishInUnitsOfTheTetrahedralization)
{
    SampledSolid solid = sampledBox({1, 1, 1}, 2, 1024.0);
    const UniformSize field(0.01);
    VolumeSizing sizing;
    sizing.field = &field;
    LengthScale3d scale(solid.tetrahedralization, sizing);
    scale.setInitial();
    EXPECT_DOUBLE_EQ(scale.size(VertexId(0)), 10.24);
    EXPECT_DOUBLE_EQ(scale.wantedAt({5, 6, 7}), 10.24);
}

TEST(LengthScale3d, KeepsALocalGuardWhenOnlyTheUserAsksForSizes)
{
    SampledSolid plate = sampledBox({1, 1, 0.05}, 4);
    const UniformSize field(0.5);
    VolumeSizing sizing;
    sizing.field = &field;
    sizing.usesLocalFeatureSize = false;
    LengthScale3d scale(plate.tetrahedralization, sizing);
    scale.setInitial();
    for (const VertexId v : liveVertices(plate.tetrahedralization.mesh())) {
        EXPECT_EQ(scale.size(v), 0.5);
        EXPECT_LE(scale.guard(v), 0.05 + 1e-12);
    }
}

TEST(LengthScale3d, GradesTheNeighbourhoodOfALoweredVertexAgain)
{
    SampledSolid solid = sampledBox({1, 1, 1}, 3);
    VolumeSizing sizing;
    sizing.grading = 10.0;
    LengthScale3d scale(solid.tetrahedralization, sizing);
    scale.setInitial();
    Triangulation3d& mesh = solid.tetrahedralization.mesh();
    mesh.setLengthScale(VertexId(0), 0.001);
    std::vector<VertexId> lowered;
    scale.gradeAgainFrom(VertexId(0), lowered);
    EXPECT_FALSE(lowered.empty());
    for (const TetId tet : meshedTets(solid)) {
        for (const VertexId a : mesh.tet(tet).vertex) {
            for (const VertexId b : mesh.tet(tet).vertex) {
                EXPECT_LE(scale.size(a),
                          1.03 * (scale.size(b) + 0.1 * length(mesh.position(a) - mesh.position(b))));
            }
        }
    }
}

}  // namespace
}  // namespace mesher::test
