#include "sizing/gradation.h"

#include "base/random.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace mesher {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct RandomGraph
{
    std::size_t nodes = 40;
    std::vector<GradationGraph::Edge> edges;
    std::vector<double> sizes;

    explicit RandomGraph(std::uint64_t seed)
    {
        Random random(seed);
        for (std::uint32_t i = 1; i < nodes; ++i)
            edges.push_back({random.below(i), i, random.between(0.1, 2.0)});
        for (int i = 0; i < 60; ++i) {
            edges.push_back({random.below(40), random.below(40), random.between(0.1, 2.0)});
        }
        for (std::size_t i = 0; i < nodes; ++i)
            sizes.push_back(random.below(3) == 0 ? random.between(0.1, 3.0) : kInfinity);
    }
};

/// Relaxes every edge until nothing changes.
std::vector<double> relaxed(const RandomGraph& graph, double grading)
{
    std::vector<double> sizes = graph.sizes;
    for (std::size_t round = 0; round < graph.nodes; ++round) {
        for (const auto& edge : graph.edges) {
            sizes[edge.a] = std::min(sizes[edge.a], sizes[edge.b] + edge.length / grading);
            sizes[edge.b] = std::min(sizes[edge.b], sizes[edge.a] + edge.length / grading);
        }
    }
    return sizes;
}

TEST(Gradation, agreesWithRelaxationUntilNothingChanges)
{
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const RandomGraph graph(seed);
        const double grading = 0.5 + 0.1 * static_cast<double>(seed);
        std::vector<double> sizes = graph.sizes;
        gradeSizes(GradationGraph::of(graph.nodes, graph.edges), grading, sizes);
        const std::vector<double> expected = relaxed(graph, grading);
        for (std::size_t i = 0; i < sizes.size(); ++i)
            EXPECT_NEAR(sizes[i], expected[i], 1e-12) << "seed " << seed;
    }
}

TEST(Gradation, dependsOnNoOrderOfTheEdges)
{
    const RandomGraph graph(7);
    std::vector<double> sizes = graph.sizes;
    gradeSizes(GradationGraph::of(graph.nodes, graph.edges), 1.5, sizes);
    std::vector<GradationGraph::Edge> reversed(graph.edges.rbegin(), graph.edges.rend());
    std::vector<double> others = graph.sizes;
    gradeSizes(GradationGraph::of(graph.nodes, reversed), 1.5, others);
    EXPECT_EQ(sizes, others);
}

TEST(Gradation, leavesUnreachableNodesWithoutASize)
{
    std::vector<double> sizes{1.0, kInfinity, kInfinity};
    const std::vector<GradationGraph::Edge> edges{{0, 1, 2.0}};
    gradeSizes(GradationGraph::of(3, edges), 2.0, sizes);
    EXPECT_EQ(sizes[1], 2.0);
    EXPECT_EQ(sizes[2], kInfinity);
}

}  // namespace
}  // namespace mesher
