#pragma once

#include "io/write_options.h"
#include "mesh/classified_mesh.h"

#include <array>
#include <cstdint>

namespace mesher {

/// One numbering of the entities of all dimensions, from 1: the solids first, then faces, edges and vertices. Many readers look
/// up a group, or an entity, by its number alone, so no two may share one. A group has the number of its entity.
class GroupNumbers
{
public:
    GroupNumbers(const ClassifiedMesh& mesh, GroupChoice choice);

    /// Of the group; 0 without an entity, and where entities of this dimension have no groups.
    [[nodiscard]] std::uint32_t numberOf(EntityRef entity) const
    {
        return entity.index != EntityRef::kNone && isGrouped(entity.dimension) ? tagOf(entity) : 0;
    }
    /// Of the entity; without one a number behind all others, by dimension.
    [[nodiscard]] std::uint32_t tagOf(EntityRef entity) const
    {
        if (entity.index == EntityRef::kNone) return before_[0] + entityCount_[0] + 4u - entity.dimension;
        return before_[entity.dimension] + entity.index + 1;
    }
    [[nodiscard]] bool isGrouped(std::uint8_t dimension) const { return dimension >= leastDimension_; }

private:
    void countEntities(const ClassifiedMesh& mesh);

    std::array<std::uint32_t, 4> entityCount_{};  ///< the largest number of people in the mesh, by dimension
    std::array<std::uint32_t, 4> before_{};       ///< entities of higher dimension
    std::uint8_t leastDimension_ = 0;
};

/// The highest dimension that the mesh has elements of.
[[nodiscard]] std::uint8_t dimensionOf(const ClassifiedMesh& mesh);

}  // namespace mesher
