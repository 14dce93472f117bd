#pragma once

#include "mesh/classified_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// A side of an element: an edge of a triangle, a face of a tetrahedron.
struct ElementSide
{
    std::uint32_t element = 0;  ///< index among the triangles or tets
    std::uint8_t side = 0;      ///< of a triangle: node i to i + 1; of a tet: opposite to node i
};

/// For each line the triangles that have it as an edge, or for each triangle the tets that have it as a face.
/// Cost  one sort of the lines (triangles), one search for each side that lies on the model's boundary
class ElementSides
{
public:
    [[nodiscard]] static ElementSides ofLines(const ClassifiedMesh& mesh);
    [[nodiscard]] static ElementSides ofTriangles(const ClassifiedMesh& mesh);

    /// In the order of the elements.
    [[nodiscard]] std::span<const ElementSide> of(std::uint32_t lower) const
    {
        return {sides_.data() + first_[lower], sides_.data() + first_[lower + 1]};
    }

private:
    std::vector<std::uint32_t> first_;
    std::vector<ElementSide> sides_;
};

}  // namespace mesher
