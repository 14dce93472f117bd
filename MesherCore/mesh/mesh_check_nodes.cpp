#include "mesh/mesh_check_steps.h"

#include <cmath>
#include <numeric>

namespace mesher::detail {

namespace {

template <std::size_t N>
std::uint64_t countBadReferences(const std::vector<MeshElement<N>>& elements, std::size_t nodeCount)
{
    std::uint64_t bad = 0;
    for (const MeshElement<N>& element : elements) {
        const std::array<std::uint32_t, N> key = sortedKey(element.node);
        if (key.back() >= nodeCount || std::adjacent_find(key.begin(), key.end()) != key.end()) ++bad;
    }
    return bad;
}

template <std::size_t N>
std::uint64_t countDuplicates(const std::vector<MeshElement<N>>& elements)
{
    const std::vector<SideRecord<N>> records = sortedRecords(elements);
    std::uint64_t duplicates = 0;
    forRuns<N>(records, [&](std::size_t first, std::size_t last) { duplicates += last - first - 1; });
    return duplicates;
}

template <std::size_t N>
void markUsed(const std::vector<MeshElement<N>>& elements, std::vector<char>& isUsed)
{
    for (const MeshElement<N>& element : elements) {
        for (const NodeId node : element.node) isUsed[node.value] = 1;
    }
}

bool isComputable(const Vec3& p)
{
    return std::abs(p.x) <= kLargestCheckedCoordinate && std::abs(p.y) <= kLargestCheckedCoordinate &&
           std::abs(p.z) <= kLargestCheckedCoordinate;  // false for what is not a number
}

constexpr std::uint32_t kNoPart = 0xFFFFFFFFu;

/// The connected part of the mesh that each node belongs to, by the elements of the highest dimension.
std::vector<std::uint32_t> partsOfNodes(const ClassifiedMesh& mesh, const std::vector<char>& isUsed)
{
    std::vector<std::uint32_t> parent(mesh.nodes.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto rootOf = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    const auto join = [&](const auto& elements) {
        for (const auto& element : elements) {
            const std::uint32_t first = rootOf(element.node.front().value);
            for (const NodeId node : element.node) parent[rootOf(node.value)] = first;
        }
    };
    join(mesh.tets);
    if (mesh.tets.empty()) join(mesh.triangles);
    for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = rootOf(i);
    for (std::uint32_t i = 0; i < parent.size(); ++i) {
        if (isUsed[i] == 0) parent[i] = kNoPart;
    }
    return parent;
}

/// Parts that touch, of solids or faces that share nothing, have nodes of their own at one place.
std::uint64_t countDuplicateNodes(const ClassifiedMesh& mesh, const std::vector<char>& isUsed)
{
    const std::vector<std::uint32_t> part = partsOfNodes(mesh, isUsed);
    std::vector<NodeId> order(mesh.nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = NodeId(i);
    std::sort(order.begin(), order.end(), [&](NodeId a, NodeId b) {
        const Vec3 &p = mesh.nodes[a].position, &q = mesh.nodes[b].position;
        return p == q ? part[a.value] < part[b.value] : isLexicographicallyLess(p, q);
    });
    std::uint64_t duplicates = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        const NodeId a = order[i - 1], b = order[i];
        const bool isApart = part[a.value] != part[b.value] && part[b.value] != kNoPart;
        if (mesh.nodes[a].position == mesh.nodes[b].position && !isApart) ++duplicates;
    }
    return duplicates;
}

/// A node may lie on the element's entity or on one of lower dimension, which bounds it.
template <std::size_t N>
void checkClassificationOf(const ClassifiedMesh& mesh, const std::vector<MeshElement<N>>& elements,
                           MeshCheckReport& report)
{
    for (const MeshElement<N>& element : elements) {
        if (element.entity.index == EntityRef::kNone) {
            ++report.unclassified;
            continue;
        }
        bool fits = element.entity.dimension == N - 1;
        for (const NodeId id : element.node) {
            const EntityRef node = mesh.nodes[id].entity;
            fits = fits && (node.dimension < element.entity.dimension || node == element.entity);
        }
        if (!fits) ++report.misclassified;
    }
}

}  // namespace

bool checkReferences(const ClassifiedMesh& mesh, MeshCheckReport& report)
{
    const std::size_t nodeCount = mesh.nodes.size();
    report.badReferences =
        countBadReferences(mesh.points, nodeCount) + countBadReferences(mesh.lines, nodeCount) +
        countBadReferences(mesh.triangles, nodeCount) + countBadReferences(mesh.tets, nodeCount);
    for (const MeshNode& node : mesh.nodes) {
        if (!isComputable(node.position)) ++report.nonFiniteNodes;
    }
    return report.badReferences == 0 && report.nonFiniteNodes == 0;
}

void checkNodes(const ClassifiedMesh& mesh, MeshCheckReport& report)
{
    std::vector<char> isUsed(mesh.nodes.size());
    if (!mesh.tets.empty()) {
        markUsed(mesh.tets, isUsed);
    } else {
        markUsed(mesh.triangles, isUsed);
    }
    report.duplicateNodes = countDuplicateNodes(mesh, isUsed);
    report.orphanNodes = static_cast<std::uint64_t>(std::count(isUsed.begin(), isUsed.end(), 0));
    report.duplicateElements = countDuplicates(mesh.points) + countDuplicates(mesh.lines) +
                               countDuplicates(mesh.triangles) + countDuplicates(mesh.tets);
}

void checkClassification(const ClassifiedMesh& mesh, MeshCheckReport& report)
{
    // Files without groups of edges and vertices tell that a node lies on one, not on which.
    const int dimension = mesh.tets.empty() ? 2 : 3;
    for (const MeshNode& node : mesh.nodes) {
        const bool isBetween = node.entity.dimension < dimension - 1;
        if (node.entity.index == EntityRef::kNone && !isBetween) ++report.unclassified;
    }
    checkClassificationOf(mesh, mesh.points, report);
    checkClassificationOf(mesh, mesh.lines, report);
    checkClassificationOf(mesh, mesh.triangles, report);
    checkClassificationOf(mesh, mesh.tets, report);
}

}  // namespace mesher::detail
