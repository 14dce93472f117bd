#include "sizing/attractor_size.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mesher {
namespace {

constexpr std::uint32_t kLeafSize = 4;

Vec3 middleOf(const Attractor& attractor) { return 0.5 * (attractor.first + attractor.last); }

double component(const Vec3& v, int axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

double distanceToBox(const Vec3& p, const Box3& box)
{
    return length(Vec3{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                       std::max({box.low.y - p.y, 0.0, p.y - box.high.y}),
                       std::max({box.low.z - p.z, 0.0, p.z - box.high.z})});
}

double distanceToSegment(const Vec3& p, const Attractor& attractor)
{
    const Vec3 edge = attractor.last - attractor.first;
    const double square = squaredLength(edge);
    const double along = square > 0.0 ? std::clamp(dot(p - attractor.first, edge) / square, 0.0, 1.0) : 0.0;
    return length(p - (attractor.first + along * edge));
}

int longestAxis(const Box3& box)
{
    const Vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

}  // namespace

AttractorSize::AttractorSize(std::vector<Attractor> attractors, const DistanceProfile& profile)
    : attractors_(std::move(attractors)), profile_(profile)
{
    if (!attractors_.empty()) build(0, static_cast<std::uint32_t>(attractors_.size()));
}

std::uint32_t AttractorSize::build(std::uint32_t begin, std::uint32_t end)
{
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Node node;
    node.begin = begin;
    node.end = end;
    Box3 middles;
    for (std::uint32_t i = begin; i < end; ++i) {
        node.box.include(attractors_[i].first);
        node.box.include(attractors_[i].last);
        node.smallest = std::min(node.smallest, attractors_[i].size);
        middles.include(middleOf(attractors_[i]));
    }
    nodes_.push_back(node);
    if (end - begin <= kLeafSize) return index;
    const int axis = longestAxis(middles);
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(attractors_.begin() + begin, attractors_.begin() + half, attractors_.begin() + end,
                     [axis](const Attractor& a, const Attractor& b) {
                         return component(middleOf(a), axis) < component(middleOf(b), axis);
                     });
    build(begin, half);
    const std::uint32_t second = build(half, end);
    nodes_[index].second = second;
    return index;
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
    if (nodes_.empty()) return smallest;
    const auto boundOf = [&](std::uint32_t node) {
        const double distance = std::max(0.0, distanceToBox(centre, nodes_[node].box) - radius);
        return sizeFrom(nodes_[node].smallest, distance);
    };
    // Halving leaves trees of less depth than bits in a number of attractors.
    std::array<std::pair<double, std::uint32_t>, 40> stack;
    std::size_t waiting = 0;
    stack[waiting++] = {boundOf(0), 0};
    while (waiting > 0) {
        const auto [bound, index] = stack[--waiting];
        if (bound >= smallest) continue;
        const Node& node = nodes_[index];
        if (node.second != 0) {
            std::pair near{boundOf(index + 1), index + 1};
            std::pair far{boundOf(node.second), node.second};
            if (far.first < near.first) std::swap(near, far);
            stack[waiting++] = far;
            stack[waiting++] = near;
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const double distance = std::max(0.0, distanceToSegment(centre, attractors_[i]) - radius);
            smallest = std::min(smallest, sizeFrom(attractors_[i].size, distance));
        }
    }
    return smallest;
}

}  // namespace mesher
