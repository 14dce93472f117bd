#pragma once

#include "base/box.h"
#include "io/entity_groups.h"
#include "mesh/classified_mesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace mesher {

/// An entity as the section $Entities of Gmsh 4.1 tells it.
struct GmshEntity
{
    Box3 box;
    bool isNamed = true;  ///< has a physical group
    std::vector<std::int64_t>
        boundary{};  ///< tags of the entities around it; of a curve first the start, last, negative, the end
};

/// The entities of a mesh by dimension and tag: the number of people, counted from 1. What lies on no entity gets an entity
/// without a group, with the number after the last, so that a reader finds a place for everything.
class GmshEntities
{
public:
    explicit GmshEntities(const ClassifiedMesh& mesh);

    [[nodiscard]] std::uint32_t tagOf(EntityRef entity) const;
    /// Where a node is listed; one without an entity in the highest dimension that the mesh has.
    [[nodiscard]] EntityRef placeOf(const MeshNode& node) const;
    [[nodiscard]] const std::map<std::uint32_t, GmshEntity>& ofDimension(std::size_t dimension) const
    {
        return entities_[dimension];
    }

private:
    template <std::size_t N>
    void include(const ClassifiedMesh& mesh, const std::vector<MeshElement<N>>& elements);
    void countEntities(const ClassifiedMesh& mesh);
    void connectCurves(const ClassifiedMesh& mesh);
    void connectSurfaces(const ClassifiedMesh& mesh);
    void connectVolumes(const ClassifiedMesh& mesh);

    std::array<std::uint32_t, 4> entityCount_{};  ///< largest number in use, by dimension
    std::array<std::map<std::uint32_t, GmshEntity>, 4> entities_;
    std::uint8_t meshDimension_ = 0;
};

}  // namespace mesher
