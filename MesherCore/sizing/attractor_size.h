#pragma once

#include "sizing/box_tree.h"
#include "sizing/shape_sizes.h"
#include "sizing/sizing_field.h"

#include <vector>

namespace mesher {

/// A place that asks for a size: a straight segment, or a point if both ends coincide. Curves are given as their polylines.
struct Attractor
{
    Vec3 first;
    Vec3 last;
    double size = 1.0;
};

/// Sizes on points and curves, growing with the distance from them: the minimum over all attractors of their size plus
/// growth times distance. Points with sizes, sizes on curves and the distance to a curve are all this field.
/// Cost         O(n log n) once; O(log n) a question, by a tree of boxes with their smallest sizes
class AttractorSize final : public SizingField
{
public:
    /// `profile` tells plateau, growth, largest and reach; each attractor has a size of its own.
    AttractorSize(std::vector<Attractor> attractors, const DistanceProfile& profile);

    [[nodiscard]] double sizeAt(const Vec3& point) const override { return smallestNear(point, 0.0); }
    [[nodiscard]] double smallestNear(const Vec3& centre, double radius) const override;

private:
    [[nodiscard]] double sizeFrom(double size, double distance) const;

    std::vector<Attractor> attractors_;  ///< in the order of the tree
    DistanceProfile profile_;
    BoxTree tree_;
    std::vector<double> smallest_;  ///< of the sizes below each node of the tree
};

}  // namespace mesher
