#include "mesh/classified_mesh_hash.h"

#include "base/random.h"

#include <algorithm>
#include <bit>

namespace mesher {

namespace {

constexpr std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) { return Random(hash ^ value)(); }

std::uint64_t hashOf(double coordinate)
{
    return std::bit_cast<std::uint64_t>(coordinate + 0.0);  // -0 and 0 are the same place
}

std::uint64_t hashOf(EntityRef entity) { return std::uint64_t{entity.dimension} << 32 | entity.index; }

std::uint64_t hashOf(const MeshNode& node)
{
    std::uint64_t hash = mixed(1, hashOf(node.position.x));
    hash = mixed(hash, hashOf(node.position.y));
    hash = mixed(hash, hashOf(node.position.z));
    return mixed(hash, hashOf(node.entity));
}

/// Corners are put into an order that keeps the orientation: the smallest hash first in lines and triangles.
template <std::size_t N>
std::uint64_t hashOf(const MeshElement<N>& element, const IdVector<NodeId, std::uint64_t>& nodeHash)
{
    std::array<std::uint64_t, N> corner{};
    for (std::size_t i = 0; i < N; ++i) corner[i] = nodeHash[element.node[i]];
    if constexpr (N == 3) {
        std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    } else if constexpr (N == 4) {
        std::sort(corner.begin(), corner.end());
    }
    std::uint64_t hash = mixed(N, hashOf(element.entity));
    for (const std::uint64_t c : corner) hash = mixed(hash, c);
    return hash;
}

template <std::size_t N>
std::uint64_t sumOfHashes(const std::vector<MeshElement<N>>& elements,
                          const IdVector<NodeId, std::uint64_t>& nodeHash)
{
    std::uint64_t sum = 0;
    for (const MeshElement<N>& element : elements) sum += hashOf(element, nodeHash);
    return sum;
}

}  // namespace

std::uint64_t classifiedMeshHash(const ClassifiedMesh& mesh)
{
    IdVector<NodeId, std::uint64_t> nodeHash;
    nodeHash.reserve(mesh.nodes.size());
    std::uint64_t sum = 0;
    for (const MeshNode& node : mesh.nodes) {
        nodeHash.push_back(hashOf(node));
        sum += nodeHash[NodeId(static_cast<std::uint32_t>(nodeHash.size() - 1))];
    }
    sum += sumOfHashes(mesh.points, nodeHash) + sumOfHashes(mesh.lines, nodeHash);
    sum += sumOfHashes(mesh.triangles, nodeHash) + sumOfHashes(mesh.tets, nodeHash);
    return mixed(0, sum);
}

}  // namespace mesher
