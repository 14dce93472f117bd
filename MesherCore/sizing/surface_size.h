#pragma once

#include "base/vec.h"
#include "sizing/box_tree.h"
#include "sizing/sizing_field.h"

#include <array>
#include <vector>

namespace mesher {

/// A triangle that stands for a piece of a surface, with the sizes wanted on it.
struct SizedTriangle
{
    std::array<Vec3, 3> corner;
    std::array<double, 3> size{};  ///< at the corners, linear between them
    double plateau = 0.0;          ///< distance within which the surface itself is: sizes grow from there
};

/// Sizes on surfaces, growing with the distance from them: the minimum over all triangles of the size at the nearest point plus
/// growth times the distance beyond the plateau.
/// Cost         O(n log n) once; O(log n) a question, by a tree of boxes with their smallest sizes
class SurfaceSize final : public SizingField
{
public:
    SurfaceSize(std::vector<SizedTriangle> triangles, double growth);

    [[nodiscard]] double sizeAt(const Vec3& point) const override { return smallestNear(point, 0.0); }
    [[nodiscard]] double smallestNear(const Vec3& centre, double radius) const override;

private:
    /// Of the triangles below a node of the tree.
    struct Least
    {
        double size = kNoSize;
        double plateau = 0.0;  ///< the largest
    };

    [[nodiscard]] double sizeFrom(double size, double distance) const;

    std::vector<SizedTriangle> triangles_;  ///< in the order of the tree
    double growth_;
    BoxTree tree_;
    std::vector<Least> least_;
};

}  // namespace mesher
