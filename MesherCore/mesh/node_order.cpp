#include "mesh/node_order.h"

#include <algorithm>
#include <utility>

namespace mesher {

IdVector<NodeId, NodeId> sortNodesByEntity(ClassifiedMesh& mesh)
{
    std::vector<NodeId> order(mesh.nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = NodeId(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](NodeId a, NodeId b) { return mesh.nodes[a].entity < mesh.nodes[b].entity; });
    IdVector<NodeId, NodeId> moved(mesh.nodes.size());
    IdVector<NodeId, MeshNode> nodes;
    nodes.reserve(mesh.nodes.size());
    for (const NodeId node : order) moved[node] = nodes.push_back(mesh.nodes[node]);
    mesh.nodes = std::move(nodes);
    const auto rename = [&](auto& elements) {
        for (auto& element : elements) {
            for (NodeId& node : element.node) node = moved[node];
        }
    };
    rename(mesh.points);
    rename(mesh.lines);
    rename(mesh.triangles);
    rename(mesh.tets);
    return moved;
}

}  // namespace mesher
