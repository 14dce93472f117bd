#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// A graph whose edges have lengths: the neighbours of node i are those from start[i] to start[i + 1].
struct GradationGraph
{
    std::vector<std::size_t> start;
    std::vector<std::uint32_t> neighbours;
    std::vector<double> lengths;

    [[nodiscard]] std::size_t nodeCount() const { return start.empty() ? 0 : start.size() - 1; }

    struct Edge
    {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        double length = 0.0;
    };
    /// Each edge is given once and followed both ways.
    [[nodiscard]] static GradationGraph of(std::size_t nodeCount, std::span<const Edge> edges);
};

/// Lowers sizes until they grow by at most the length over `grading` along every edge: size(v) = min over all nodes w of
/// size(w) + distance(v, w) / grading.
/// Guarantees   the largest such sizes; they do not depend on the numbering of the nodes or edges
/// Requires     grading > 0; positive sizes, infinite ones included
/// Cost         one multi-source Dijkstra search, O(edges log nodes)
/// Reference    thesis Equations 2.1 and 4.2, which applied once per vertex depend on the order of the vertices
void gradeSizes(const GradationGraph& graph, double grading, std::span<double> sizes);

}  // namespace mesher
