#pragma once

#include "mesh/classified_mesh.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// The triangles that have no tetrahedra on both sides, by index and in their order: of solids the outer boundary, of faces alone
/// all. For formats of surfaces, in which a face between two solids would be a wall inside of what is closed.
[[nodiscard]] std::vector<std::uint32_t> outerTriangles(const ClassifiedMesh& mesh);

}  // namespace mesher
