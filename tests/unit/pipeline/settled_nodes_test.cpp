#include "pipeline/settled_nodes.h"

#include "brep/analytic/solids.h"
#include "mesh/classified_mesh_hash.h"
#include "mesh/mesh_check.h"
#include "pipeline/mesh_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesher {
namespace {

ClassifiedMesh meshOf(const BrepModel& model, double size)
{
    MeshOptions options;
    options.size = size;
    RunContext context;
    MeshOutcome outcome = meshModel(model, options, nullptr, 4, context);
    EXPECT_TRUE(outcome.mesh);
    return std::move(*outcome.mesh);
}

/// Coordinates of nodes on the boundary that are not zero and less than any that a point of this size can tell from it.
std::size_t countNoise(const ClassifiedMesh& mesh, double scale)
{
    std::size_t count = 0;
    for (const MeshNode& node : mesh.nodes) {
        if (node.entity.dimension == 3) continue;
        for (const double x : {node.position.x, node.position.y, node.position.z})
            count += x != 0.0 && std::abs(x) < 8e-16 * scale ? 1 : 0;
    }
    return count;
}

/// Nodes on entities of a dimension below 3, each coordinate a few units in the last place of `scale` off.
ClassifiedMesh withNoise(ClassifiedMesh mesh, double scale)
{
    std::uint32_t i = 0;
    for (MeshNode& node : mesh.nodes) {
        const double noise =
            (static_cast<double>(i++ % 7) - 3.0) * std::numeric_limits<double>::epsilon() * scale;
        if (node.entity.dimension == 3) continue;
        node.position = node.position + Vec3{noise, -noise, noise};
    }
    return mesh;
}

TEST(SettledNodes, HaveTheCoordinateOfTheirPlaneWhateverTheUnit)
{
    for (const double unit : {1e-5, 1.0, 1e6}) {
        const BrepModel model = makeCylinder(Axes{}, 1.7 * unit, 4.3 * unit).value();
        ClassifiedMesh mesh = withNoise(meshOf(model, 0.8 * unit), 4.3 * unit);
        const SettledNodes settled = settleNodes(mesh, model);
        EXPECT_GT(settled.settled, 20u);
        EXPECT_EQ(settled.kept, 0u);
        std::size_t onEnds = 0;
        for (const MeshNode& node : mesh.nodes) {
            const double z = node.position.z;
            if (std::abs(z) > 1e-9 * unit && std::abs(z - 4.3 * unit) > 1e-9 * unit) continue;
            EXPECT_TRUE(z == 0.0 || z == 4.3 * unit) << z;
            ++onEnds;
        }
        EXPECT_GT(onEnds, 20u);
        EXPECT_EQ(countNoise(mesh, unit), 0u);
        EXPECT_TRUE(checkMesh(mesh).isValid());
    }
}

TEST(SettledNodes, SettleOnce)
{
    const BrepModel model = makeCylinder(Axes{}, 1.7, 4.3).value();
    ClassifiedMesh mesh = withNoise(meshOf(model, 0.8), 4.3);
    static_cast<void>(settleNodes(mesh, model));
    const std::uint64_t hash = classifiedMeshHash(mesh);
    EXPECT_EQ(settleNodes(mesh, model).settled, 0u);
    EXPECT_EQ(classifiedMeshHash(mesh), hash);
}

TEST(SettledNodes, AreThoseOfEveryMesh)
{
    EXPECT_EQ(countNoise(meshOf(makeSphere(Axes{}, 16.0).value(), 6.0), 16.0), 0u);
    EXPECT_EQ(countNoise(meshOf(makeTorus(Axes{}, 8.0, 2.0).value(), 2.0), 8.0), 0u);
}

TEST(SettledNodes, LeaveWhatIsNoNoise)
{
    const BrepModel model = makeBox({}, {1.0, 1.0, 1.0}).value();
    ClassifiedMesh mesh = meshOf(model, 0.5);
    for (MeshNode& node : mesh.nodes) {
        if (node.entity.dimension < 3) node.position.z += 1e-12;
    }
    EXPECT_EQ(settleNodes(mesh, model).settled, 0u);
}

/// Three corners on the floor and a fourth node of its face above them by less than rounding: flat, it would have no volume.
TEST(SettledNodes, StayWhereATetrahedronNeedsThem)
{
    const BrepModel model = makeBox({}, {1.0, 1.0, 1.0}).value();
    ClassifiedMesh whole = meshOf(model, 0.5);
    std::uint32_t floor = EntityRef::kNone;
    for (const MeshElement<3>& triangle : whole.triangles) {
        const bool isLow = std::all_of(triangle.node.begin(), triangle.node.end(),
                                       [&](NodeId n) { return whole.nodes[n].position.z == 0.0; });
        if (isLow) floor = triangle.entity.index;
    }
    ClassifiedMesh mesh;
    for (const Vec3& p :
         {Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.25, 0.25, 1e-16}})
        mesh.nodes.push_back({p, {2, floor}, {}});
    mesh.triangles.push_back({{NodeId(0), NodeId(2), NodeId(1)}, {2, floor}});
    mesh.tets.push_back({{NodeId(0), NodeId(1), NodeId(2), NodeId(3)}, {3, 0}});
    const SettledNodes settled = settleNodes(mesh, model);
    EXPECT_EQ(settled.settled, 0u);
    EXPECT_EQ(settled.kept, 1u);
    EXPECT_EQ(mesh.nodes[NodeId(3)].position.z, 1e-16);
}

}  // namespace
}  // namespace mesher
