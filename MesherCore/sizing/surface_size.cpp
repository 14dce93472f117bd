#include "sizing/surface_size.h"

#include "sizing/distances.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace mesher {
namespace {

BoxTree treeOf(const std::vector<SizedTriangle>& triangles)
{
    std::vector<Box3> boxes;
    boxes.reserve(triangles.size());
    for (const SizedTriangle& triangle : triangles) boxes.push_back(Box3::of(triangle.corner));
    return BoxTree(boxes);
}

}  // namespace

SurfaceSize::SurfaceSize(std::vector<SizedTriangle> triangles, double growth)
    : growth_(growth), tree_(treeOf(triangles))
{
    triangles_.reserve(triangles.size());
    for (const std::uint32_t i : tree_.order()) triangles_.push_back(triangles[i]);
    for (const BoxTree::Node& node : tree_.nodes()) {
        Least least;
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const SizedTriangle& triangle = triangles_[i];
            least.size = std::min({least.size, triangle.size[0], triangle.size[1], triangle.size[2]});
            least.plateau = std::max(least.plateau, triangle.plateau);
        }
        least_.push_back(least);
    }
}

double SurfaceSize::sizeFrom(double size, double distance) const
{
    return size + growth_ * std::max(0.0, distance);
}

double SurfaceSize::smallestNear(const Vec3& centre, double radius) const
{
    double smallest = kNoSize;
    const auto boundOf = [&](std::uint32_t node) {
        const double distance = std::sqrt(squaredDistance(centre, tree_.nodes()[node].box));
        return sizeFrom(least_[node].size, distance - least_[node].plateau - radius);
    };
    const auto look = [&](std::uint32_t i) {
        const auto& [corner, size, plateau] = triangles_[i];
        const std::array<double, 3> weight = closestWeights(centre, corner);
        const Vec3 foot = weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2];
        const double there = weight[0] * size[0] + weight[1] * size[1] + weight[2] * size[2];
        smallest = std::min(smallest, sizeFrom(there, length(centre - foot) - plateau - radius));
        return smallest;
    };
    tree_.searchSmallest(boundOf, look, smallest);
    return smallest;
}

}  // namespace mesher
