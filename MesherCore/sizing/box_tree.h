#pragma once

#include "base/box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mesher {

/// Boxes in halves of halves, split along the longest extent of their middles.
/// Cost         O(n log n) to make
class BoxTree
{
public:
    struct Node
    {
        Box3 box;
        std::uint32_t begin = 0;  ///< of the items below it, in `order`
        std::uint32_t end = 0;
        std::uint32_t second = 0;  ///< the second child; the first one follows the node; 0 for a leaf

        [[nodiscard]] bool isLeaf() const { return second == 0; }
    };

    explicit BoxTree(std::span<const Box3> boxes);

    /// A node comes before its children.
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    /// Indices of the boxes, those of a node side by side.
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

    /// Looks for the smallest value: `boundOf` tells of a node, by its index, what no item below it can fall short of, `look` is
    /// shown the items (places in `order`) and returns the smallest value so far.
    /// Guarantees   nodes that cannot better that value are passed over; the nearer half comes first
    template <class BoundOf, class Look>
    void searchSmallest(BoundOf boundOf, Look look, double smallest) const
    {
        if (nodes_.empty()) return;
        std::array<std::pair<double, std::uint32_t>, kDeepest> stack;
        std::size_t waiting = 0;
        stack[waiting++] = {boundOf(0u), 0u};
        while (waiting > 0) {
            const auto [bound, index] = stack[--waiting];
            if (bound >= smallest) continue;
            const Node& node = nodes_[index];
            if (node.isLeaf()) {
                for (std::uint32_t i = node.begin; i < node.end; ++i) smallest = look(i);
                continue;
            }
            std::pair near{boundOf(index + 1), index + 1};
            std::pair far{boundOf(node.second), node.second};
            if (far.first < near.first) std::swap(near, far);
            stack[waiting++] = far;
            stack[waiting++] = near;
        }
    }

private:
    /// Halving makes no tree deeper than the bits of an index; a level adds one to those that wait.
    static constexpr std::size_t kDeepest = 40;

    std::uint32_t build(std::span<const Box3> boxes, std::uint32_t begin, std::uint32_t end);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace mesher
