#include "mesh/classified_mesh_hash.h"

#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mesher {
namespace {

TEST(ClassifiedMeshHash, DoesNotDependOnNumbering)
{
    const ClassifiedMesh mesh = test::twoSolidMesh();
    ClassifiedMesh renumbered = mesh;
    const auto count = static_cast<std::uint32_t>(mesh.nodes.size());
    for (std::uint32_t i = 0; i < count; ++i) renumbered.nodes[NodeId(count - 1 - i)] = mesh.nodes[NodeId(i)];
    const auto renumber = [&](auto& elements) {
        for (auto& element : elements) {
            for (NodeId& node : element.node) node = NodeId(count - 1 - node.value);
        }
        std::reverse(elements.begin(), elements.end());
    };
    renumber(renumbered.points);
    renumber(renumbered.lines);
    renumber(renumbered.triangles);
    renumber(renumbered.tets);
    for (auto& triangle : renumbered.triangles) {
        std::rotate(triangle.node.begin(), triangle.node.begin() + 1, triangle.node.end());
    }
    EXPECT_EQ(classifiedMeshHash(renumbered), classifiedMeshHash(mesh));
}

TEST(ClassifiedMeshHash, TellsApartWhatDiffers)
{
    const ClassifiedMesh mesh = test::twoSolidMesh();
    const std::uint64_t hash = classifiedMeshHash(mesh);
    ClassifiedMesh changed = mesh;
    changed.nodes[NodeId(3)].position.x = std::nextafter(changed.nodes[NodeId(3)].position.x, 9.0);
    EXPECT_NE(classifiedMeshHash(changed), hash);
    changed = mesh;
    changed.triangles[0].entity.index += 1;
    EXPECT_NE(classifiedMeshHash(changed), hash);
    changed = mesh;
    std::swap(changed.triangles[0].node[0], changed.triangles[0].node[1]);
    EXPECT_NE(classifiedMeshHash(changed), hash);
    changed = mesh;
    changed.tets.pop_back();
    EXPECT_NE(classifiedMeshHash(changed), hash);
    changed = mesh;
    changed.nodes[NodeId(3)].entity.dimension = 0;
    EXPECT_NE(classifiedMeshHash(changed), hash);
}

}  // namespace
}  // namespace mesher
