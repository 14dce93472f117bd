#include "quality/quality_statistics.h"

#include "base/random.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace mesher {
namespace {

TEST(RangeStatistics, KeepsLeastLargestAndMean)
{
    RangeStatistics range;
    EXPECT_EQ(range.mean(), 0.0);
    for (const double value : {3.0, -1.0, 4.0}) range.add(value);
    EXPECT_EQ(range.least(), -1.0);
    EXPECT_EQ(range.largest(), 4.0);
    EXPECT_EQ(range.mean(), 2.0);
    EXPECT_EQ(range.count(), 3u);
}

TEST(AngleHistogram, PutsABoundaryIntoTheUpperBinAnd180IntoTheLast)
{
    AngleHistogram histogram{};
    for (const double angle : {0.0, 9.99, 10.0, 179.0, 180.0}) addAngle(histogram, angle);
    EXPECT_EQ(histogram[0], 2u);
    EXPECT_EQ(histogram[1], 1u);
    EXPECT_EQ(histogram[17], 2u);
}

TEST(TriangleQuality, OfAGridOfHalfSquares)
{
    const ClassifiedMesh mesh = test::twoFaceMesh(5);
    const TriangleQuality quality = triangleQualityOf(mesh);
    EXPECT_NEAR(quality.angle.least(), 45.0, 1e-9);
    EXPECT_NEAR(quality.angle.largest(), 90.0, 1e-9);
    EXPECT_NEAR(quality.angle.mean(), 60.0, 1e-9);
    EXPECT_NEAR(quality.shortestEdge, 0.1, 1e-12);
    EXPECT_NEAR(quality.area.mean() * static_cast<double>(mesh.triangles.size()), 0.5, 1e-12);
    EXPECT_EQ(std::accumulate(quality.angleHistogram.begin(), quality.angleHistogram.end(), std::uint64_t{0}),
              3 * mesh.triangles.size());
}

TEST(TriangleQuality, NamesTheWorstTriangle)
{
    ClassifiedMesh mesh = test::twoFaceMesh(2);
    // The corner (0, 0) is pulled towards the opposite corner of its triangles.
    mesh.nodes[NodeId(0)].position = {0.09, 0.09, 0.0};
    const TriangleQuality quality = triangleQualityOf(mesh);
    const auto& worst = mesh.triangles[quality.worst].node;
    EXPECT_TRUE(worst[0] == NodeId(0) || worst[1] == NodeId(0) || worst[2] == NodeId(0));
    EXPECT_LT(quality.angle.least(), 10.0);
}

TEST(TetQuality, OfKuhnsTetrahedra)
{
    const ClassifiedMesh mesh = test::twoSolidMesh(2);
    const TetQuality quality = tetQualityOf(mesh);
    EXPECT_NEAR(quality.dihedral.least(), 45.0, 1e-9);
    EXPECT_NEAR(quality.dihedral.largest(), 90.0, 1e-9);
    EXPECT_NEAR(quality.volume.mean() * static_cast<double>(mesh.tets.size()), 0.4 * 0.2 * 0.2, 1e-14);
    EXPECT_NEAR(quality.radiusRatio.least(), quality.radiusRatio.largest(), 1e-9);
    EXPECT_EQ(
        std::accumulate(quality.dihedralHistogram.begin(), quality.dihedralHistogram.end(), std::uint64_t{0}),
        6 * mesh.tets.size());
}

TEST(TetQuality, TellsTheAnglesThatArcTangentsTell)
{
    Random random(7);
    ClassifiedMesh mesh;
    TetQuality expected;
    double smallest = 360.0;
    for (std::size_t i = 0; i < 2000; ++i) {
        MeshElement<4> tet;
        // From well shaped ones to slivers that are nearly flat.
        const double height = std::pow(10.0, -8.0 * random.unit());
        for (std::size_t corner = 0; corner < 4; ++corner) {
            MeshNode node;
            node.position = {random.unit(), random.unit(), height * random.unit()};
            tet.node[corner] = mesh.nodes.push_back(node);
        }
        mesh.tets.push_back(tet);
        for (const double angle : dihedralAngles(cornersOf(mesh, tet))) {
            expected.dihedral.add(angle);
            addAngle(expected.dihedralHistogram, angle);
            if (angle >= smallest) continue;
            smallest = angle;
            expected.worst = i;
        }
    }
    const TetQuality quality = tetQualityOf(mesh);
    EXPECT_EQ(quality.dihedral.least(), expected.dihedral.least());
    EXPECT_EQ(quality.dihedral.largest(), expected.dihedral.largest());
    EXPECT_EQ(quality.dihedralHistogram, expected.dihedralHistogram);
    EXPECT_EQ(quality.worst, expected.worst);
}

}  // namespace
}  // namespace mesher
