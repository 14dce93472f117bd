#pragma once

#include "base/box.h"
#include "mesh/classified_mesh.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// The volume that the tetrahedra of two solids of a mesh have in common, where each is meshed for itself.
/// Guarantees   exact up to rounding for up to 20,000 tetrahedra of the solid that has more of them where they meet; of more, every
///              second, third, … stands for all
/// Cost         a clipping of each of these with those of the other solid whose boxes it meets
class CommonVolumes
{
public:
    explicit CommonVolumes(const ClassifiedMesh& mesh);

    /// Model units cubed; solids by index.
    [[nodiscard]] double between(std::uint32_t first, std::uint32_t second) const;

private:
    struct Tet
    {
        std::uint32_t index = 0;
        Box3 box;
    };

    [[nodiscard]] std::vector<Tet> tetsIn(std::uint32_t solid, const Box3& box) const;

    const ClassifiedMesh& mesh_;
    std::vector<std::vector<std::uint32_t>> tetsOf_;  ///< by solid
    std::vector<Box3> boxOf_;                         ///< by solid
};

}  // namespace mesher
