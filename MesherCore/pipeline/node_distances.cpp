#include "pipeline/node_distances.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <array>
#include <limits>

namespace mesher {

namespace {

std::optional<FaceDistance> distanceOf(const MeshNode& node, const BrepModel& model)
{
    if (node.entity.index == EntityRef::kNone || !isInModel(node.entity, model)) return std::nullopt;
    if (node.entity.dimension == 0) {
        const BrepVertex& vertex = model.vertices[BrepVertexId(node.entity.index)];
        return FaceDistance{length(node.position - vertex.position), vertex.tolerance, {}};
    }
    if (node.entity.dimension == 1) {
        const BrepEdge& edge = model.edges[BrepEdgeId(node.entity.index)];
        if (edge.isDegenerate) return std::nullopt;
        return FaceDistance{edge.curve->project(node.position, edge.part).distance, edge.tolerance, {}};
    }
    if (node.entity.dimension == 2) {
        return distanceFromFace(model, BrepFaceId(node.entity.index), node.position, node.parameters);
    }
    return std::nullopt;
}

/// Finds the feet of nodes that seem off their face from those of their neighbours on it.
class NeighbourSeeds
{
public:
    NeighbourSeeds(const ClassifiedMesh& mesh, const BrepModel& model,
                   std::vector<std::optional<FaceDistance>>& found)
        : mesh_(mesh), model_(model), found_(found)
    {
        for (std::uint32_t i = 0; i < found.size(); ++i) {
            if (isOff(NodeId(i))) neighbours_.insert(NodeId(i), {});
        }
        if (neighbours_.empty()) return;
        for (const MeshElement<3>& triangle : mesh.triangles) {
            for (const NodeId a : triangle.node) {
                for (const NodeId b : triangle.node) {
                    if (a != b && mesh.nodes[a].entity == mesh.nodes[b].entity) join(a, b);
                }
            }
        }
    }

    void run()
    {
        std::vector<NodeId> waiting;
        for (const auto& [node, neighbours] : neighbours_) waiting.push_back(node);
        while (!waiting.empty()) {
            const NodeId node = waiting.back();
            waiting.pop_back();
            if (!isOff(node) || !isSettled(node)) continue;
            for (const NodeId next : *neighbours_.find(node)) {
                if (isOff(next)) waiting.push_back(next);
            }
        }
    }

private:
    [[nodiscard]] bool isOff(NodeId node) const
    {
        return mesh_.nodes[node].entity.dimension == 2 && found_[node.value] &&
               !isOn(*found_[node.value], mesh_.nodes[node].position);
    }

    void join(NodeId a, NodeId b)
    {
        if (std::vector<NodeId>* neighbours = neighbours_.find(a)) neighbours->push_back(b);
    }

    /// Does the foot of a neighbour lead to one on the face?
    bool isSettled(NodeId id)
    {
        const MeshNode& node = mesh_.nodes[id];
        for (const NodeId neighbour : *neighbours_.find(id)) {
            if (isOff(neighbour)) continue;
            const FaceDistance again = distanceFromFace(model_, BrepFaceId(node.entity.index), node.position,
                                                        found_[neighbour.value]->parameters);
            if (!isOn(again, node.position)) continue;
            found_[id.value] = again;
            return true;
        }
        return false;
    }

    const ClassifiedMesh& mesh_;
    const BrepModel& model_;
    std::vector<std::optional<FaceDistance>>& found_;
    IndexedMap<NodeId, std::vector<NodeId>> neighbours_;  ///< of nodes that seem off their face
};

}  // namespace

bool isInModel(EntityRef entity, const BrepModel& model)
{
    const std::array<std::size_t, 4> counts = {model.vertices.size(), model.edges.size(), model.faces.size(),
                                               model.solids.size()};
    return entity.index == EntityRef::kNone ||
           (entity.dimension < 4 && entity.index < counts[entity.dimension]);
}

bool isOn(const FaceDistance& found, const Vec3& place)
{
    // A spline's place is a sum of some ten products, and its closest point another one.
    constexpr double kRounding = 64.0 * std::numeric_limits<double>::epsilon();
    return found.distance <= std::max({kNodeTolerance, found.tolerance, kRounding * length(place)});
}

std::vector<std::optional<FaceDistance>> distancesOfNodes(const ClassifiedMesh& mesh, const BrepModel& model)
{
    std::vector<std::optional<FaceDistance>> found;
    found.reserve(mesh.nodes.size());
    for (const MeshNode& node : mesh.nodes) found.push_back(distanceOf(node, model));
    NeighbourSeeds(mesh, model, found).run();
    return found;
}

}  // namespace mesher
