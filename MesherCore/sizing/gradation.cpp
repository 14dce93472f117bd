#include "sizing/gradation.h"

#include "base/assert.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace mesher {

GradationGraph GradationGraph::of(std::size_t nodeCount, std::span<const Edge> edges)
{
    GradationGraph graph;
    graph.start.assign(nodeCount + 1, 0);
    for (const Edge& edge : edges) {
        ++graph.start[edge.a + 1];
        ++graph.start[edge.b + 1];
    }
    for (std::size_t i = 1; i <= nodeCount; ++i) graph.start[i] += graph.start[i - 1];
    graph.neighbours.resize(graph.start.back());
    graph.lengths.resize(graph.start.back());
    std::vector<std::size_t> next(graph.start.begin(), graph.start.end() - 1);
    const auto add = [&](std::uint32_t from, std::uint32_t to, double length) {
        graph.neighbours[next[from]] = to;
        graph.lengths[next[from]++] = length;
    };
    for (const Edge& edge : edges) {
        add(edge.a, edge.b, edge.length);
        add(edge.b, edge.a, edge.length);
    }
    return graph;
}

void gradeSizes(const GradationGraph& graph, double grading, std::span<double> sizes)
{
    MESHER_PRECONDITION(grading > 0.0 && sizes.size() == graph.nodeCount());
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (std::uint32_t i = 0; i < sizes.size(); ++i) {
        if (std::isfinite(sizes[i])) front.emplace(sizes[i], i);
    }
    while (!front.empty()) {
        const auto [size, node] = front.top();
        front.pop();
        if (size > sizes[node]) continue;
        for (std::size_t i = graph.start[node]; i < graph.start[node + 1]; ++i) {
            const std::uint32_t neighbour = graph.neighbours[i];
            const double graded = size + graph.lengths[i] / grading;
            if (graded >= sizes[neighbour]) continue;
            sizes[neighbour] = graded;
            front.emplace(graded, neighbour);
        }
    }
}

}  // namespace mesher
