#include "sizing/attractor_size.h"

#include "sizing/distances.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace mesher {
namespace {

BoxTree treeOf(const std::vector<Attractor>& attractors)
{
    std::vector<Box3> boxes;
    boxes.reserve(attractors.size());
    for (const Attractor& attractor : attractors)
        boxes.push_back(Box3::of(std::array{attractor.first, attractor.last}));
    return BoxTree(boxes);
}

double distanceTo(const Vec3& p, const Attractor& attractor)
{
    const double share = closestShare(p, attractor.first, attractor.last);
    return length(p - (attractor.first + share * (attractor.last - attractor.first)));
}

}  // namespace

AttractorSize::AttractorSize(std::vector<Attractor> attractors, const DistanceProfile& profile)
    : profile_(profile), tree_(treeOf(attractors))
{
    attractors_.reserve(attractors.size());
    for (const std::uint32_t i : tree_.order()) attractors_.push_back(attractors[i]);
    for (const BoxTree::Node& node : tree_.nodes()) {
        double smallest = kNoSize;
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            smallest = std::min(smallest, attractors_[i].size);
        smallest_.push_back(smallest);
    }
}

double AttractorSize::sizeFrom(double size, double distance) const
{
    DistanceProfile profile = profile_;
    profile.size = size;
    return profile.at(distance);
}

double AttractorSize::smallestNear(const Vec3& centre, double radius) const
{
    double smallest = kNoSize;
    const auto boundOf = [&](std::uint32_t node) {
        const double distance = std::sqrt(squaredDistance(centre, tree_.nodes()[node].box));
        return sizeFrom(smallest_[node], std::max(0.0, distance - radius));
    };
    const auto look = [&](std::uint32_t i) {
        const double distance = std::max(0.0, distanceTo(centre, attractors_[i]) - radius);
        return smallest = std::min(smallest, sizeFrom(attractors_[i].size, distance));
    };
    tree_.searchSmallest(boundOf, look, smallest);
    return smallest;
}

}  // namespace mesher
