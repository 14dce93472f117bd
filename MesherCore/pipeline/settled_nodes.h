#pragma once

#include "brep/brep_model.h"
#include "mesh/classified_mesh.h"

#include <cstdint>

namespace mesher {

struct SettledNodes
{
    std::uint64_t settled = 0;  ///< nodes with a coordinate that was taken from their entity
    std::uint64_t kept = 0;     ///< nodes that a tetrahedron beside them did not let go there
};

/// Frees the coordinates of nodes on vertices, edges and faces from the noise of their evaluation: where all of an entity, or of
/// one that it bounds, has one coordinate (a plane or a line across an axis, a circle in such a plane), its nodes get just that;
/// and what is zero to within the rounding of the entity's own size is zero.
/// Guarantees   no node moves by more than 16 units in the last place of the largest coordinate of its entity; tetrahedra keep
///              their orientation; settling again changes nothing
[[nodiscard]] SettledNodes settleNodes(ClassifiedMesh& mesh, const BrepModel& model);

}  // namespace mesher
