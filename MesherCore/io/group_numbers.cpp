#include "io/group_numbers.h"

#include <algorithm>

namespace mesher {

GroupNumbers::GroupNumbers(const ClassifiedMesh& mesh, GroupChoice choice)
{
    countEntities(mesh);
    for (std::size_t d = 3; d > 0; --d) before_[d - 1] = before_[d] + entityCount_[d];
    const std::uint8_t dimension = dimensionOf(mesh);
    if (choice == GroupChoice::Bounding && dimension > 0)
        leastDimension_ = static_cast<std::uint8_t>(dimension - 1);
}

void GroupNumbers::countEntities(const ClassifiedMesh& mesh)
{
    const auto count = [&](EntityRef entity) {
        if (entity.index == EntityRef::kNone) return;
        entityCount_[entity.dimension] = std::max(entityCount_[entity.dimension], entity.index + 1);
    };
    for (const MeshNode& node : mesh.nodes) count(node.entity);
    const auto countAll = [&](const auto& elements) {
        for (const auto& element : elements) count(element.entity);
    };
    countAll(mesh.points);
    countAll(mesh.lines);
    countAll(mesh.triangles);
    countAll(mesh.tets);
}

std::uint8_t dimensionOf(const ClassifiedMesh& mesh)
{
    if (!mesh.tets.empty()) return 3;
    if (!mesh.triangles.empty()) return 2;
    return mesh.lines.empty() ? 0 : 1;
}

}  // namespace mesher
