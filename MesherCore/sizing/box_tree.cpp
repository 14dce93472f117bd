#include "sizing/box_tree.h"

#include <algorithm>
#include <numeric>

namespace mesher {

namespace {

constexpr std::uint32_t kLeafSize = 4;

double component(const Vec3& v, int axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

int longestAxis(const Vec3& extent)
{
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

Vec3 middleOf(const Box3& box) { return 0.5 * (box.low + box.high); }

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) : order_(boxes.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes.empty()) build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
}

std::uint32_t BoxTree::build(std::span<const Box3> boxes, std::uint32_t begin, std::uint32_t end)
{
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Node node{{}, begin, end, 0};
    Box3 middles;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Box3& box = boxes[order_[i]];
        node.box.include(box.low);
        node.box.include(box.high);
        middles.include(middleOf(box));
    }
    nodes_.push_back(node);
    if (end - begin <= kLeafSize) return index;
    const int axis = longestAxis(middles.extent());
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double ofA = component(middleOf(boxes[a]), axis);
                         const double ofB = component(middleOf(boxes[b]), axis);
                         return ofA != ofB ? ofA < ofB : a < b;
                     });
    build(boxes, begin, half);
    const std::uint32_t second = build(boxes, half, end);
    nodes_[index].second = second;
    return index;
}

}  // namespace mesher
