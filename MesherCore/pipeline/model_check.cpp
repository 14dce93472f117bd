#include "pipeline/model_check.h"

#include "pipeline/node_distances.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace mesher {

namespace {

template <std::size_t N>
std::uint64_t countUnknown(const std::vector<MeshElement<N>>& elements, const BrepModel& model)
{
    return static_cast<std::uint64_t>(
        std::count_if(elements.begin(), elements.end(),
                      [&](const auto& element) { return !isInModel(element.entity, model); }));
}

/// Vertices at the ends of the edges that the mesh has lines on.
std::uint64_t countMissingVertices(const ClassifiedMesh& mesh, const BrepModel& model)
{
    std::vector<char> isWanted(model.vertices.size());
    for (const MeshElement<2>& line : mesh.lines) {
        if (line.entity.dimension != 1 || line.entity.index >= model.edges.size()) continue;
        const BrepEdge& edge = model.edges[BrepEdgeId(line.entity.index)];
        isWanted[edge.first.value] = 1;
        isWanted[edge.last.value] = 1;
    }
    for (const MeshNode& node : mesh.nodes) {
        if (node.entity.dimension == 0 && node.entity.index < isWanted.size())
            isWanted[node.entity.index] = 0;
    }
    // A vertex may be represented by another one that is at the same place.
    for (std::uint32_t v = 0; v < isWanted.size(); ++v) {
        if (isWanted[v] == 0) continue;
        const Vec3& place = model.vertices[BrepVertexId(v)].position;
        const bool isThere = std::any_of(mesh.nodes.begin(), mesh.nodes.end(), [&](const MeshNode& node) {
            return node.entity.dimension == 0 && length(node.position - place) <= kNodeTolerance;
        });
        if (isThere) isWanted[v] = 0;
    }
    return static_cast<std::uint64_t>(std::count(isWanted.begin(), isWanted.end(), 1));
}

/// The vertices and edges that bound each face or lie in it.
class FaceClosures
{
public:
    explicit FaceClosures(const BrepModel& model) : model_(model), entities_(model.faces.size())
    {
        for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
            const BrepFace& face = model.faces[BrepFaceId(f)];
            for (const BrepLoop& loop : face.loops) {
                for (const BrepCoedge& coedge : loop.coedges) addEdge(BrepFaceId(f), coedge.edge);
            }
            for (const BrepEdgeId edge : face.embeddedEdges) addEdge(BrepFaceId(f), edge);
            for (const BrepVertexId v : face.embeddedVertices)
                entities_[BrepFaceId(f)].push_back({0, v.value});
            std::sort(entities_[BrepFaceId(f)].begin(), entities_[BrepFaceId(f)].end());
        }
    }

    /// A node of another entity, as where a body touches itself, has to be where the face is.
    [[nodiscard]] bool contains(BrepFaceId f, const MeshNode& node) const
    {
        if (node.entity == EntityRef{2, f.value}) return true;
        const std::vector<EntityRef>& own = entities_[f];
        if (std::binary_search(own.begin(), own.end(), node.entity)) return true;
        return isOn(distanceFromFace(model_, f, node.position), node.position);
    }

private:
    void addEdge(BrepFaceId f, BrepEdgeId e)
    {
        const BrepEdge& edge = model_.edges[e];
        entities_[f].push_back({1, e.value});
        entities_[f].push_back({0, edge.first.value});
        entities_[f].push_back({0, edge.last.value});
    }

    const BrepModel& model_;
    IdVector<BrepFaceId, std::vector<EntityRef>> entities_;
};

std::uint64_t countTrianglesOff(const ClassifiedMesh& mesh, const BrepModel& model)
{
    const FaceClosures closures(model);
    std::uint64_t count = 0;
    for (const MeshElement<3>& triangle : mesh.triangles) {
        if (triangle.entity.dimension != 2 || triangle.entity.index >= model.faces.size()) continue;
        const bool liesOn = std::all_of(triangle.node.begin(), triangle.node.end(), [&](NodeId node) {
            return closures.contains(BrepFaceId(triangle.entity.index), mesh.nodes[node]);
        });
        count += liesOn ? 0 : 1;
    }
    return count;
}

}  // namespace

ModelCheckReport checkAgainstModel(const ClassifiedMesh& mesh, const BrepModel& model)
{
    ModelCheckReport report;
    report.unknownEntities = countUnknown(mesh.points, model) + countUnknown(mesh.lines, model) +
                             countUnknown(mesh.triangles, model) + countUnknown(mesh.tets, model);
    const std::vector<std::optional<FaceDistance>> distances = distancesOfNodes(mesh, model);
    for (std::uint32_t i = 0; i < distances.size(); ++i) {
        const MeshNode& node = mesh.nodes[NodeId(i)];
        if (!isInModel(node.entity, model)) {
            ++report.unknownEntities;
            continue;
        }
        if (!distances[i]) continue;
        const FaceDistance& found = *distances[i];
        if (!isOn(found, node.position)) ++report.nodesOff;
        double& largest = report.largestDistance[node.entity.dimension];
        if (found.distance > largest) {
            largest = found.distance;
            report.farthestEntity[node.entity.dimension] = nameOf(node.entity);
        }
    }
    report.missingVertices = countMissingVertices(mesh, model);
    report.trianglesOff = countTrianglesOff(mesh, model);
    return report;
}

std::vector<std::string> ModelCheckReport::problems() const
{
    std::vector<std::string> problems;
    const auto tell = [&](std::uint64_t count, const char* what) {
        if (count != 0) problems.push_back(std::to_string(count) + what);
    };
    tell(nodesOff, " nodes are off their entity of the model");
    tell(unknownEntities, " nodes or elements name an entity that the model does not have");
    tell(missingVertices, " vertices of the model are no nodes");
    tell(trianglesOff, " triangles name a face that they do not lie on");
    return problems;
}

}  // namespace mesher
