#include "io/element_sides.h"

#include <algorithm>
#include <utility>

namespace mesher {

namespace {

template <std::size_t N>
using Key = std::array<NodeId, N>;

template <std::size_t N>
Key<N> sorted(Key<N> key)
{
    std::sort(key.begin(), key.end());
    return key;
}

/// The node of corner k of side `side` of a triangle (M = 3) or tetrahedron (M = 4).
template <std::size_t M>
Key<M - 1> sideNodes(const MeshElement<M>& element, std::uint8_t side)
{
    Key<M - 1> nodes{};
    if constexpr (M == 3) {
        nodes = {element.node[side], element.node[(side + 1u) % 3u]};
    } else {
        for (std::size_t k = 0, next = 0; k < M; ++k) {
            if (k != side) nodes[next++] = element.node[k];
        }
    }
    return nodes;
}

/// Pairs of (index of the lower element, side of the upper one), sorted by the former.
template <std::size_t M>
std::vector<std::pair<std::uint32_t, ElementSide>> matchSides(const ClassifiedMesh& mesh,
                                                              const std::vector<MeshElement<M - 1>>& lower,
                                                              const std::vector<MeshElement<M>>& upper)
{
    std::vector<std::pair<Key<M - 1>, std::uint32_t>> keys;
    keys.reserve(lower.size());
    std::vector<char> isOnLower(mesh.nodes.size());
    for (std::uint32_t i = 0; i < lower.size(); ++i) {
        keys.emplace_back(sorted<M - 1>(lower[i].node), i);
        for (const NodeId node : lower[i].node) isOnLower[node.value] = 1;
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::pair<std::uint32_t, ElementSide>> matches;
    for (std::uint32_t e = 0; e < upper.size(); ++e) {
        for (std::uint8_t side = 0; side < M; ++side) {
            const Key<M - 1> nodes = sideNodes<M>(upper[e], side);
            const bool canMatch =
                std::all_of(nodes.begin(), nodes.end(), [&](NodeId n) { return isOnLower[n.value] != 0; });
            if (!canMatch) continue;
            const std::pair<Key<M - 1>, std::uint32_t> wanted(sorted<M - 1>(nodes), 0);
            for (auto at = std::lower_bound(keys.begin(), keys.end(), wanted);
                 at != keys.end() && at->first == wanted.first; ++at) {
                matches.push_back({at->second, {e, side}});
            }
        }
    }
    std::stable_sort(matches.begin(), matches.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return matches;
}

void collect(const std::vector<std::pair<std::uint32_t, ElementSide>>& matches, std::size_t lowerCount,
             std::vector<std::uint32_t>& first, std::vector<ElementSide>& sides)
{
    first.assign(lowerCount + 1, 0);
    for (const auto& match : matches) ++first[match.first + 1];
    for (std::size_t i = 0; i < lowerCount; ++i) first[i + 1] += first[i];
    sides.reserve(matches.size());
    for (const auto& match : matches) sides.push_back(match.second);
}

}  // namespace

ElementSides ElementSides::ofLines(const ClassifiedMesh& mesh)
{
    ElementSides result;
    collect(matchSides<3>(mesh, mesh.lines, mesh.triangles), mesh.lines.size(), result.first_, result.sides_);
    return result;
}

ElementSides ElementSides::ofTriangles(const ClassifiedMesh& mesh)
{
    ElementSides result;
    collect(matchSides<4>(mesh, mesh.triangles, mesh.tets), mesh.triangles.size(), result.first_,
            result.sides_);
    return result;
}

}  // namespace mesher
