#include "pipeline/common_volume.h"

#include "base/random.h"
#include "pipeline/tet_clipping.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mesher {
namespace {

constexpr TetPoints kUnit = {Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0},
                             Vec3{0.0, 0.0, 1.0}};

TetPoints moved(TetPoints tet, const Vec3& shift, double scale = 1.0)
{
    for (Vec3& p : tet) p = scale * p + shift;
    return tet;
}

TEST(TetClipping, KnowsSimpleCases)
{
    EXPECT_NEAR(commonVolume(kUnit, kUnit), 1.0 / 6.0, 1e-15);
    EXPECT_NEAR(commonVolume(kUnit, moved(kUnit, {0.1, 0.1, 0.1}, 0.2)), 0.008 / 6.0, 1e-15);
    EXPECT_NEAR(commonVolume(moved(kUnit, {0.1, 0.1, 0.1}, 0.2), kUnit), 0.008 / 6.0, 1e-15);
    EXPECT_EQ(commonVolume(kUnit, moved(kUnit, {2.0, 0.0, 0.0})), 0.0);
    // Moved by a quarter along x, the corner that is left is one of three quarters.
    EXPECT_NEAR(commonVolume(kUnit, moved(kUnit, {0.25, 0.0, 0.0})), 0.75 * 0.75 * 0.75 / 6.0, 1e-15);
}

/// By counting random points, which knows nothing of planes that cut.
TEST(TetClipping, AgreesWithPointsThatAreInBoth)
{
    Random random(11);
    const auto point = [&] { return Vec3{random.unit(), random.unit(), random.unit()}; };
    const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        return dot(cross(b - a, c - a), d - a);
    };
    const auto tet = [&] {
        TetPoints t = {point(), point(), point(), point()};
        if (volume(t[0], t[1], t[2], t[3]) < 0.0) std::swap(t[0], t[1]);
        return t;
    };
    const auto contains = [&](const TetPoints& t, const Vec3& p) {
        return volume(p, t[1], t[2], t[3]) > 0.0 && volume(t[0], p, t[2], t[3]) > 0.0 &&
               volume(t[0], t[1], p, t[3]) > 0.0 && volume(t[0], t[1], t[2], p) > 0.0;
    };
    constexpr int kPoints = 20'000;
    for (int i = 0; i < 30; ++i) {
        const TetPoints a = tet();
        const TetPoints b = tet();
        int inside = 0;
        for (int k = 0; k < kPoints; ++k) {
            const Vec3 p = point();
            inside += contains(a, p) && contains(b, p) ? 1 : 0;
        }
        const double counted = static_cast<double>(inside) / kPoints;
        EXPECT_NEAR(commonVolume(a, b), counted, 5.0 * std::sqrt((counted + 1e-4) / kPoints));
        EXPECT_NEAR(commonVolume(a, b), commonVolume(b, a), 1e-12);
    }
}

/// Two grids of cells of different sizes, the second one shifted into the first.
ClassifiedMesh twoGrids(std::uint32_t cells, std::uint32_t otherCells, const Vec3& shift)
{
    ClassifiedMesh mesh = test::gridMesh({{0, cells}, {0, cells}, {0, cells}, 1.0 / cells});
    const ClassifiedMesh other =
        test::gridMesh({{0, otherCells}, {0, otherCells}, {0, otherCells}, 1.0 / otherCells});
    const auto first = static_cast<std::uint32_t>(mesh.nodes.size());
    for (MeshNode node : other.nodes) {
        node.position = node.position + shift;
        mesh.nodes.push_back(node);
    }
    for (MeshElement<4> element : other.tets) {
        for (NodeId& node : element.node) node = NodeId(node.value + first);
        element.entity.index = 1;
        mesh.tets.push_back(element);
    }
    return mesh;
}

TEST(CommonVolumes, OfBoxesAreThoseOfTheirBoxes)
{
    const ClassifiedMesh mesh = twoGrids(3, 5, {0.5, 0.4, 0.3});
    EXPECT_NEAR(CommonVolumes(mesh).between(0, 1), 0.5 * 0.6 * 0.7, 1e-12);
    EXPECT_NEAR(CommonVolumes(mesh).between(1, 0), 0.5 * 0.6 * 0.7, 1e-12);
    EXPECT_EQ(CommonVolumes(twoGrids(3, 5, {2.0, 0.0, 0.0})).between(0, 1), 0.0);
    EXPECT_EQ(CommonVolumes(mesh).between(0, 7), 0.0);
}

TEST(CommonVolumes, OfFineMeshesAreNear)
{
    const ClassifiedMesh mesh =
        twoGrids(20, 2, {0.25, 0.25, 0.0});  // 27,000 tetrahedra of the first are in the second
    EXPECT_NEAR(CommonVolumes(mesh).between(0, 1), 0.75 * 0.75, 0.01);
}

}  // namespace
}  // namespace mesher
