#pragma once

#include "mesh/classified_mesh.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace mesher {

/// A run of elements (or nodes) of one entity in the order that EntityGroups gives.
struct EntityGroup
{
    EntityRef entity;
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    [[nodiscard]] std::uint32_t size() const { return last - first; }
    [[nodiscard]] bool isNamed() const { return entity.index != EntityRef::kNone; }
};

/// Items put together by entity: by dimension, then by index, those without an entity last of their dimension; within a group
/// in their old order.
struct EntityGroups
{
    std::vector<std::uint32_t> order;  ///< indices of the items
    std::vector<EntityGroup> groups;   ///< ranges of `order`

    template <class EntityOf>
    EntityGroups(std::size_t count, EntityOf entityOf) : order(count)
    {
        for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
        const auto isBefore = [&](std::uint32_t a, std::uint32_t b) { return entityOf(a) < entityOf(b); };
        // Meshes mostly come sorted.
        if (!std::is_sorted(order.begin(), order.end(), isBefore)) {
            std::stable_sort(order.begin(), order.end(), isBefore);
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const EntityRef entity = entityOf(order[i]);
            if (groups.empty() || groups.back().entity != entity) groups.push_back({entity, i, i});
            groups.back().last = i + 1;
        }
    }
};

/// Elements of N nodes by the entity of their own dimension that they lie on.
template <std::size_t N>
[[nodiscard]] EntityGroups groupByEntity(const std::vector<MeshElement<N>>& elements)
{
    constexpr auto kDimension = static_cast<std::uint8_t>(N - 1);
    return EntityGroups(elements.size(), [&](std::uint32_t i) {
        const EntityRef entity = elements[i].entity;
        return entity.dimension == kDimension ? entity : EntityRef{kDimension, EntityRef::kNone};
    });
}

}  // namespace mesher
