#pragma once

#include "base/vec.h"
#include "sizing/box_tree.h"
#include "sizing/region_size.h"

#include <array>
#include <vector>

namespace mesher {

/// The inside of closed surfaces of triangles, turned either way: tells inside from outside by how many triangles are above a
/// point, up to the distance of the triangles from the faces that they stand for.
/// Guarantees   a point whose ray meets an edge or corner counts one of the triangles there, whichever way they are turned
/// Cost         O(n log n) to make; a question looks at the triangles above and below the point
class SolidRegion final : public SizeRegion
{
public:
    explicit SolidRegion(std::vector<std::array<Vec3, 3>> triangles);

    [[nodiscard]] bool contains(const Vec3& point) const override;

private:
    std::vector<std::array<Vec3, 3>> triangles_;  ///< sheared, in the order of the tree
    BoxTree tree_;
};

}  // namespace mesher
