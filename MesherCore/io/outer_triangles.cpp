#include "io/outer_triangles.h"

#include "io/element_sides.h"

namespace mesher {

std::vector<std::uint32_t> outerTriangles(const ClassifiedMesh& mesh)
{
    const ElementSides sides = ElementSides::ofTriangles(mesh);
    std::vector<std::uint32_t> outer;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (sides.of(i).size() < 2) outer.push_back(i);
    }
    return outer;
}

}  // namespace mesher
