#pragma once

#include "mesh/classified_mesh.h"

#include <cstdint>

namespace mesher {

/// A number that tells finished meshes apart by the places of their nodes, their elements and the entities of both, whatever
/// the numbering of nodes and elements: equal meshes have equal hashes on every platform.
/// Cost: linear.
[[nodiscard]] std::uint64_t classifiedMeshHash(const ClassifiedMesh& mesh);

}  // namespace mesher
