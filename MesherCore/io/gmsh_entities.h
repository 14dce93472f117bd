#pragma once

#include "base/box.h"
#include "io/entity_groups.h"
#include "io/group_numbers.h"
#include "mesh/classified_mesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace mesher {

/// An entity as the section $Entities of Gmsh 4.1 tells it.
struct GmshEntity
{
    EntityRef entity{};
    std::uint32_t group = 0;  ///< number of its physical group, 0 without one
    Box3 box{};
    std::vector<std::int64_t>
        boundary{};  ///< tags of the entities around it; of a curve first the start, last, negative, the end
};

/// The entities of a mesh by dimension and tag, which is that of GroupNumbers. What lies on no entity gets an entity without a
/// group, so that a reader finds a place for everything. Elements of entities that
/// could have a group and were not wished to are not written, as Gmsh does it.
class GmshEntities
{
public:
    GmshEntities(const ClassifiedMesh& mesh, GroupChoice groups);

    [[nodiscard]] std::uint32_t tagOf(EntityRef entity) const { return numbers_.tagOf(entity); }
    /// Where a node is listed; one without an entity in the highest dimension that the mesh has.
    [[nodiscard]] EntityRef placeOf(const MeshNode& node) const;
    /// Whether elements of this dimension are written.
    [[nodiscard]] bool hasElements(std::uint8_t dimension) const { return numbers_.isGrouped(dimension); }
    [[nodiscard]] std::uint32_t groupOf(EntityRef entity) const { return numbers_.numberOf(entity); }
    [[nodiscard]] const std::map<std::uint32_t, GmshEntity>& ofDimension(std::size_t dimension) const
    {
        return entities_[dimension];
    }

private:
    GmshEntity& at(EntityRef entity);
    template <std::size_t N>
    void include(const ClassifiedMesh& mesh, const std::vector<MeshElement<N>>& elements);
    void connectCurves(const ClassifiedMesh& mesh);
    void connectSurfaces(const ClassifiedMesh& mesh);
    void connectVolumes(const ClassifiedMesh& mesh);

    GroupNumbers numbers_;
    std::array<std::map<std::uint32_t, GmshEntity>, 4> entities_;
    std::uint8_t meshDimension_ = 0;
};

}  // namespace mesher
