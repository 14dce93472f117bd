#pragma once

#include "mesh/mesh_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace mesher::detail {

/// Coordinates up to this size have exact orientation tests whatever their differences.
inline constexpr double kLargestCheckedCoordinate = 0x1p300;

/// An N-node element or side under its sorted nodes, for finding equal ones by sorting.
template <std::size_t N>
struct SideRecord
{
    std::array<std::uint32_t, N> key;
    std::uint32_t owner;  ///< index of the element it comes from
    std::uint8_t side;    ///< number of the side in the owner

    friend bool operator<(const SideRecord& a, const SideRecord& b)
    {
        return a.key != b.key ? a.key < b.key : (a.owner != b.owner ? a.owner < b.owner : a.side < b.side);
    }
};

template <std::size_t N>
[[nodiscard]] std::array<std::uint32_t, N> sortedKey(std::array<NodeId, N> nodes)
{
    std::sort(nodes.begin(), nodes.end());
    std::array<std::uint32_t, N> key{};
    for (std::size_t i = 0; i < N; ++i) key[i] = nodes[i].value;
    return key;
}

template <std::size_t N>
[[nodiscard]] std::vector<SideRecord<N>> sortedRecords(const std::vector<MeshElement<N>>& elements)
{
    std::vector<SideRecord<N>> records;
    records.reserve(elements.size());
    for (std::uint32_t i = 0; i < elements.size(); ++i)
        records.push_back({sortedKey(elements[i].node), i, 0});
    std::sort(records.begin(), records.end());
    return records;
}

/// Calls visit(first, last) for each run of records with equal keys.
template <std::size_t N, class Visit>
void forRuns(const std::vector<SideRecord<N>>& records, Visit visit)
{
    for (std::size_t first = 0; first < records.size();) {
        std::size_t last = first + 1;
        while (last < records.size() && records[last].key == records[first].key) ++last;
        visit(first, last);
        first = last;
    }
}

template <std::size_t N>
[[nodiscard]] bool containsKey(const std::vector<SideRecord<N>>& records,
                               const std::array<std::uint32_t, N>& key)
{
    const auto found = std::lower_bound(records.begin(), records.end(), key,
                                        [](const SideRecord<N>& r, const auto& k) { return r.key < k; });
    return found != records.end() && found->key == key;
}

/// False if the mesh is so broken that its elements cannot be looked at.
[[nodiscard]] bool checkReferences(const ClassifiedMesh& mesh, MeshCheckReport& report);
void checkNodes(const ClassifiedMesh& mesh, MeshCheckReport& report);
void checkClassification(const ClassifiedMesh& mesh, MeshCheckReport& report);
void checkSurface(const ClassifiedMesh& mesh, MeshCheckReport& report);
void checkVolume(const ClassifiedMesh& mesh, MeshCheckReport& report);

}  // namespace mesher::detail
