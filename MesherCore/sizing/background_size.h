#pragma once

#include "base/result.h"
#include "sizing/box_tree.h"
#include "sizing/sizing_field.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace mesher {

/// A mesh with a size at each node: triangles (of a plane or surface) or tetrahedra.
struct BackgroundMesh
{
    std::vector<Vec3> nodes;
    std::vector<double> sizes;  ///< one per node, positive
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint32_t, 4>> tets;
};

/// Interpolates the sizes of a background mesh linearly; outside of it, at the nearest point of it.
/// Refuses      meshes without elements, indices of nodes that do not exist, sizes that are not positive numbers
/// Cost         O(n log n) once, O(log n) a question
class BackgroundSize final : public SizingField
{
public:
    [[nodiscard]] static Result<std::shared_ptr<const BackgroundSize>> make(BackgroundMesh mesh);
    [[nodiscard]] double sizeAt(const Vec3& point) const override;

private:
    BackgroundSize(BackgroundMesh mesh, BoxTree tree);

    BackgroundMesh mesh_;
    BoxTree tree_;  ///< over the elements, triangles first
};

}  // namespace mesher
