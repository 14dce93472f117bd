#include "sizing/box_tree.h"

#include "base/random.h"
#include "sizing/distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesher {
namespace {

Vec3 randomPoint(Random& random)
{
    return {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
}

std::vector<Box3> randomBoxes(Random& random, std::size_t count)
{
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 corner = randomPoint(random);
        boxes.push_back(Box3::of(std::array{corner, corner + 0.1 * randomPoint(random)}));
    }
    return boxes;
}

double smallestBySearch(const BoxTree& tree, const std::vector<Box3>& boxes, const Vec3& p,
                        std::size_t& looks)
{
    double smallest = std::numeric_limits<double>::infinity();
    tree.searchSmallest([&](std::uint32_t node) { return squaredDistance(p, tree.nodes()[node].box); },
                        [&](std::uint32_t i) {
                            ++looks;
                            return smallest = std::min(smallest, squaredDistance(p, boxes[tree.order()[i]]));
                        },
                        smallest);
    return smallest;
}

TEST(BoxTree, FindsTheNearestBoxAndLooksAtFew)
{
    Random random(7);
    for (const std::size_t count : {1u, 4u, 5u, 17u, 2000u}) {
        const std::vector<Box3> boxes = randomBoxes(random, count);
        const BoxTree tree(boxes);
        std::size_t looks = 0;
        constexpr int kQuestions = 200;
        for (int i = 0; i < kQuestions; ++i) {
            const Vec3 p = 1.5 * randomPoint(random);
            double nearest = std::numeric_limits<double>::infinity();
            for (const Box3& box : boxes) nearest = std::min(nearest, squaredDistance(p, box));
            EXPECT_EQ(smallestBySearch(tree, boxes, p, looks), nearest);
        }
        EXPECT_LT(looks, kQuestions * (20 + 20 * static_cast<std::size_t>(
                                                     std::log2(static_cast<double>(count) + 1.0))));
    }
}

TEST(BoxTree, HoldsEachBoxOnceInANodeThatContainsIt)
{
    Random random(8);
    const std::vector<Box3> boxes = randomBoxes(random, 333);
    const BoxTree tree(boxes);
    std::vector<int> seen(boxes.size(), 0);
    for (const BoxTree::Node& node : tree.nodes()) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            EXPECT_TRUE(node.box.contains(boxes[tree.order()[i]].low));
            EXPECT_TRUE(node.box.contains(boxes[tree.order()[i]].high));
            if (node.isLeaf()) ++seen[tree.order()[i]];
        }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(boxes.size()));
}

TEST(BoxTree, EndsForBoxesThatCoincide)
{
    const std::vector<Box3> boxes(1000, Box3::of(std::array{Vec3{}, Vec3{1.0, 1.0, 1.0}}));
    std::size_t looks = 0;
    EXPECT_EQ(smallestBySearch(BoxTree(boxes), boxes, {3.0, 0.0, 0.0}, looks), 4.0);
    EXPECT_EQ(smallestBySearch(BoxTree({}), {}, {3.0, 0.0, 0.0}, looks),
              std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace mesher
