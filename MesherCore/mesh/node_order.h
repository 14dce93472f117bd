#pragma once

#include "base/id_vector.h"
#include "mesh/classified_mesh.h"

namespace mesher {

/// Puts the nodes in the order of their entities: those on vertices first, then those on edges, faces and in solids, within an
/// entity in their old order. Formats with blocks of nodes by entity then number them as all others do.
/// Returns  the new id of each old one
IdVector<NodeId, NodeId> sortNodesByEntity(ClassifiedMesh& mesh);

}  // namespace mesher
