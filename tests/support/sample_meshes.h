#pragma once

#include "mesh/classified_mesh.h"

#include <cstdint>
#include <vector>

namespace mesher::test {

/// A rectangular grid whose lines at the given levels of each axis are features: they bound the entities.
struct GridLayout
{
    std::vector<std::uint32_t> xLevels;  ///< ascending, from 0 to the number of cells
    std::vector<std::uint32_t> yLevels;
    std::vector<std::uint32_t> zLevels;  ///< only one, {0}, for a plane mesh
    double step = 0.1;  ///< side of a cell; a coordinate is the step times the number of the grid line
};

/// The grid cut into triangles (two a cell) or tetrahedra (six a cell), fully classified; entities are counted by their class
/// along z, then y, then x. Valid by construction.
[[nodiscard]] ClassifiedMesh gridMesh(const GridLayout& layout);

/// Two faces side by side with an edge between them, in the plane z = 0.
[[nodiscard]] ClassifiedMesh twoFaceMesh(std::uint32_t cells = 4);
/// Two solids side by side with a face between them.
[[nodiscard]] ClassifiedMesh twoSolidMesh(std::uint32_t cells = 2);

}  // namespace mesher::test
