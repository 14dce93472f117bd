#include "surface_sampling/face_topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace mesher {

namespace {

Vec2 startOf(const BrepModel& model, const BrepCoedge& coedge)
{
    const Interval part = model.edges[coedge.edge].part;
    return coedge.parameterCurve->position(coedge.isReversed ? part.last : part.first);
}

double signedArea(const BrepModel& model, const BrepLoop& loop)
{
    constexpr int kSteps = 48;
    double area = 0.0;
    for (const BrepCoedge& coedge : loop.coedges) {
        const Interval part = model.edges[coedge.edge].part;
        const Vec2 origin = startOf(model, loop.coedges.front());
        Vec2 previous = startOf(model, coedge) - origin;
        for (int i = 1; i <= kSteps; ++i) {
            const double share = static_cast<double>(i) / kSteps;
            const double t = part.at(coedge.isReversed ? 1.0 - share : share);
            const Vec2 next = coedge.parameterCurve->position(t) - origin;
            area += 0.5 * cross(previous, next);
            previous = next;
        }
    }
    return area;
}

/// Do loops meet, each other or themselves, in a vertex of the parameter plane?
bool haveTouchingLoops(const BrepModel& model, const BrepFace& face)
{
    constexpr double kCloseness = 1e-7;
    struct Visit
    {
        BrepVertexId vertex;
        Vec2 place;
    };
    std::vector<Visit> visits;
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model.edges[coedge.edge];
            visits.push_back({coedge.isReversed ? edge.last : edge.first, startOf(model, coedge)});
        }
    }
    std::stable_sort(visits.begin(), visits.end(),
                     [](const Visit& a, const Visit& b) { return a.vertex < b.vertex; });
    const double reachU = kCloseness * face.boundsU.length(), reachV = kCloseness * face.boundsV.length();
    for (std::size_t i = 0; i < visits.size(); ++i) {
        for (std::size_t j = i + 1; j < visits.size() && visits[j].vertex == visits[i].vertex; ++j) {
            const Vec2 d = visits[j].place - visits[i].place;
            if (std::abs(d.x) <= reachU && std::abs(d.y) <= reachV) return true;
        }
    }
    return false;
}

/// Outer loops that share an edge, as across a seam, bound one component.
int countComponents(const std::vector<const BrepLoop*>& outer)
{
    std::vector<std::size_t> group(outer.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    std::vector<std::pair<BrepEdgeId, std::size_t>> uses;
    for (std::size_t i = 0; i < outer.size(); ++i) {
        for (const BrepCoedge& coedge : outer[i]->coedges) uses.emplace_back(coedge.edge, i);
    }
    std::sort(uses.begin(), uses.end());
    int components = static_cast<int>(outer.size());
    for (std::size_t k = 1; k < uses.size(); ++k) {
        const std::size_t a = group[uses[k - 1].second], b = group[uses[k].second];
        if (uses[k].first != uses[k - 1].first || a == b) continue;
        std::replace(group.begin(), group.end(), std::max(a, b), std::min(a, b));
        --components;
    }
    return components;
}

}  // namespace

FaceTopology topologyOf(const BrepModel& model, const BrepFace& face)
{
    std::vector<const BrepLoop*> outer;
    int holes = 0;
    std::vector<BrepVertexId> vertices;
    std::vector<BrepEdgeId> edges;
    for (const BrepLoop& loop : face.loops) {
        if (signedArea(model, loop) > 0.0) {
            outer.push_back(&loop);
        } else {
            ++holes;
        }
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model.edges[coedge.edge];
            vertices.push_back(edge.first);
            vertices.push_back(edge.last);
            if (!edge.isDegenerate) edges.push_back(coedge.edge);
        }
    }
    const auto countDistinct = [](auto& ids) {
        std::sort(ids.begin(), ids.end());
        return static_cast<int>(std::unique(ids.begin(), ids.end()) - ids.begin());
    };
    FaceTopology topology;
    topology.components = countComponents(outer);
    // The open domain of the parameters, then the vertices and edges that close it, each counted once.
    const int open = static_cast<int>(outer.size()) - holes;
    if (!haveTouchingLoops(model, face)) {
        topology.eulerCharacteristic = open + countDistinct(vertices) - countDistinct(edges);
    }
    return topology;
}

bool isClosedShell(const BrepModel& model, const BrepShell& shell)
{
    std::vector<int> balance(model.edges.size(), 0);
    for (const BrepShellFace& use : shell.faces) {
        for (const BrepLoop& loop : model.faces[use.face].loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                if (model.edges[coedge.edge].isDegenerate) continue;
                balance[coedge.edge.value] += coedge.isReversed == use.isReversed ? 1 : -1;
            }
        }
    }
    return !shell.faces.empty() && std::all_of(balance.begin(), balance.end(), [](int b) { return b == 0; });
}

}  // namespace mesher
