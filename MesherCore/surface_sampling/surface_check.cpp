#include "surface_sampling/surface_check.h"

#include "base/indexed_map.h"
#include "brep/face_area.h"
#include "surface_sampling/face_topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

namespace mesher {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

using DirectedEdge = std::pair<NodeId, NodeId>;

double angleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(length(cross(a, b)), dot(a, b)) * kDegreesPerRadian;
}

std::string nameOf(NodeId node) { return "node " + std::to_string(node.value); }

/// Facets and segments by the entity they lie on.
struct Partition
{
    IdVector<BrepFaceId, std::vector<FacetId>> facets;
    IdVector<BrepEdgeId, std::vector<SegmentId>> segments;

    Partition(const BrepModel& model, const SurfaceMesh& mesh)
        : facets(model.faces.size()), segments(model.edges.size())
    {
        for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
            if (mesh.facets[FacetId(i)].isAlive()) facets[mesh.facets[FacetId(i)].face].push_back(FacetId(i));
        }
        for (std::uint32_t i = 0; i < mesh.segments.size(); ++i) {
            const SurfaceSegment& segment = mesh.segments[SegmentId(i)];
            if (segment.isAlive()) segments[segment.edge].push_back(SegmentId(i));
        }
    }
};

class FaceChecker
{
public:
    FaceChecker(const BrepModel& model, const SurfaceMesh& mesh, const Partition& partition,
                const SurfaceCheckOptions& options, BrepFaceId id)
        : model_(model),
          mesh_(mesh),
          partition_(partition),
          options_(options),
          id_(id),
          face_(model.faces[id]),
          facets_(partition.facets[id])
    {
    }

    FaceCheck run()
    {
        check_.facets = facets_.size();
        if (facets_.empty()) {
            add("has no facets");
            return std::move(check_);
        }
        collectEdges();
        checkBoundary();
        checkTopology();
        for (const FacetId facet : facets_) checkGeometry(mesh_.facets[facet]);
        checkArea();
        return std::move(check_);
    }

private:
    void add(const std::string& what) { check_.report.add(mesher::nameOf(id_) + " " + what); }

    void collectEdges()
    {
        for (const FacetId id : facets_) {
            const SurfaceFacet& facet = mesh_.facets[id];
            for (std::size_t i = 0; i < 3; ++i) {
                const NodeId a = facet.node[i], b = facet.node[(i + 1) % 3];
                if (a == b) add("has a facet with a node twice, " + nameOf(a));
                const auto [user, isNew] = users_.insert({a, b}, id);
                if (!isNew)
                    add("uses the edge from " + nameOf(a) + " to " + nameOf(b) + " twice in one sense");
            }
        }
    }

    /// Segments of the loops are sides of one facet each, in the loop's direction; all other edges have two facets.
    void checkBoundary()
    {
        IndexedMap<DirectedEdge, int> required;
        for (const BrepLoop& loop : face_.loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                for (const SegmentId s : partition_.segments[coedge.edge]) {
                    auto [a, b] = mesh_.segments[s].node;
                    if (coedge.isReversed) std::swap(a, b);
                    ++required[{a, b}];
                    if (!users_.contains({a, b})) {
                        add("has no facet at " + mesher::nameOf(coedge.edge) + " from " + nameOf(a) + " to " +
                            nameOf(b));
                    }
                }
            }
        }
        for (const auto& [edge, facet] : users_) {
            if (users_.contains({edge.second, edge.first}) || required.contains(edge)) continue;
            add("is open between " + nameOf(edge.first) + " and " + nameOf(edge.second));
        }
        for (const auto& [edge, count] : required) {
            const bool isTwoSided = required.contains({edge.second, edge.first});
            if (!isTwoSided && users_.contains({edge.second, edge.first})) {
                add("goes on beyond its boundary from " + nameOf(edge.first) + " to " + nameOf(edge.second));
            }
        }
    }

    void checkTopology()
    {
        IndexedMap<NodeId, int> nodes;
        IndexedMap<DirectedEdge, int> edges;
        for (const FacetId id : facets_) {
            for (const NodeId node : mesh_.facets[id].node) nodes.insert(node, 0);
        }
        for (const auto& [edge, facet] : users_) edges.insert(unorderedPair(edge.first, edge.second), 0);
        check_.eulerCharacteristic = static_cast<int>(nodes.size()) - static_cast<int>(edges.size()) +
                                     static_cast<int>(facets_.size());
        check_.components = countComponents();
        const FaceTopology expected = topologyOf(model_, face_);
        if (check_.components != expected.components) {
            add("has " + std::to_string(check_.components) + " components, its loops bound " +
                std::to_string(expected.components));
        }
        if (expected.eulerCharacteristic && check_.eulerCharacteristic != *expected.eulerCharacteristic) {
            add("has the Euler characteristic " + std::to_string(check_.eulerCharacteristic) +
                ", its loops that of " + std::to_string(*expected.eulerCharacteristic));
        }
    }

    /// Of facets joined by edges.
    [[nodiscard]] int countComponents() const
    {
        IndexedMap<FacetId, std::uint32_t> index;
        for (const FacetId id : facets_) index.insert(id, static_cast<std::uint32_t>(index.size()));
        std::vector<std::uint32_t> parent(facets_.size());
        std::iota(parent.begin(), parent.end(), 0u);
        const auto rootOf = [&](std::uint32_t i) {
            while (parent[i] != i) i = parent[i] = parent[parent[i]];
            return i;
        };
        int components = static_cast<int>(facets_.size());
        for (const auto& [edge, facet] : users_) {
            const FacetId* other = users_.find({edge.second, edge.first});
            if (other == nullptr) continue;
            const std::uint32_t a = rootOf(*index.find(facet)), b = rootOf(*index.find(*other));
            if (a == b) continue;
            parent[std::max(a, b)] = std::min(a, b);
            --components;
        }
        return components;
    }

    /// How far a point of the boundary may lie from the face.
    [[nodiscard]] double slackOf(const MeshNode& node) const
    {
        double slack =
            std::max(options_.absoluteDistance, options_.relativeDistance * length(model_.box.extent()));
        if (node.entity.dimension == 2) return slack;
        slack = std::max(slack, face_.tolerance);
        for (const BrepLoop& loop : face_.loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                const BrepEdge& edge = model_.edges[coedge.edge];
                slack =
                    std::max({slack, 2.0 * coedge.gap, edge.tolerance, model_.vertices[edge.first].tolerance,
                              model_.vertices[edge.last].tolerance});
            }
        }
        return slack;
    }

    /// An edge may lie off its face between the places where the gap was measured: no parameters do better then.
    [[nodiscard]] bool isClosest(Vec2 uv, const MeshNode& node, double distance) const
    {
        constexpr double kSlack = 1.1;
        if (node.entity.dimension == 2) return false;
        return distance <= kSlack * face_.surface->project(node.position, uv).distance;
    }

    void checkGeometry(const SurfaceFacet& facet)
    {
        const Vec3& a = mesh_.nodes[facet.node[0]].position;
        const Vec3& b = mesh_.nodes[facet.node[1]].position;
        const Vec3& c = mesh_.nodes[facet.node[2]].position;
        const Vec3 normal = cross(b - a, c - a);
        check_.area += 0.5 * length(normal);
        if (!(squaredLength(normal) > 0.0)) add("has a facet without area at " + nameOf(facet.node[0]));
        for (std::size_t i = 0; i < 3; ++i) {
            const SurfacePoint exact = face_.surface->evaluate(facet.parameters[i]);
            const MeshNode& node = mesh_.nodes[facet.node[i]];
            const double distance = length(exact.position - node.position);
            if (!(distance <= slackOf(node)) && !isClosest(facet.parameters[i], node, distance)) {
                add("has " + nameOf(facet.node[i]) + " " + std::to_string(distance) + " off its parameters");
            }
            const Vec3 surfaceNormal = exact.normal();
            // Where the parametrisation ends in a point it tells no normal.
            constexpr double kSingular = 1e-9;
            const double u = length(exact.du), v = length(exact.dv);
            if (!(length(surfaceNormal) > kSingular * u * v && std::min(u, v) > kSingular * std::max(u, v)))
                continue;
            const double angle = angleBetween(normal, surfaceNormal);
            check_.worstCornerAngle = std::max(check_.worstCornerAngle, angle);
            if (!(angle < options_.maxCornerAngle)) {
                add("has a facet that is turned by " + std::to_string(angle) + " degrees at " +
                    nameOf(facet.node[i]));
            }
        }
    }

    void checkArea()
    {
        check_.exactArea = areaOf(model_, face_);
        if (std::abs(check_.area - check_.exactArea) <= options_.maxAreaDefect * check_.exactArea) return;
        add("has facets of the area " + std::to_string(check_.area) + ", its own is " +
            std::to_string(check_.exactArea));
    }

    const BrepModel& model_;
    const SurfaceMesh& mesh_;
    const Partition& partition_;
    const SurfaceCheckOptions& options_;
    BrepFaceId id_;
    const BrepFace& face_;
    const std::vector<FacetId>& facets_;
    FaceCheck check_;
    IndexedMap<DirectedEdge, FacetId> users_;
};

void checkNodes(const BrepModel& model, const SurfaceMesh& mesh, const SurfaceCheckOptions& options,
                CheckReport& report)
{
    const double allowed =
        std::max(options.absoluteDistance, options.relativeDistance * length(model.box.extent()));
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        const MeshNode& node = mesh.nodes[NodeId(i)];
        const std::uint32_t entity = node.entity.index;
        Vec3 exact;
        if (node.entity.dimension == 0 && entity < model.vertices.size()) {
            exact = model.vertices[BrepVertexId(entity)].position;
        } else if (node.entity.dimension == 1 && entity < model.edges.size() &&
                   model.edges[BrepEdgeId(entity)].curve) {
            exact = model.edges[BrepEdgeId(entity)].curve->position(node.parameters.x);
        } else if (node.entity.dimension == 2 && entity < model.faces.size()) {
            exact = model.faces[BrepFaceId(entity)].surface->position(node.parameters);
        } else {
            report.add(nameOf(NodeId(i)) + " has no entity");
            continue;
        }
        if (!(length(exact - node.position) <= allowed)) {
            report.add(nameOf(NodeId(i)) + " lies " + std::to_string(length(exact - node.position)) +
                       " off " + nameOf(node.entity));
        }
    }
}

/// From the first vertex of each edge to its last, without gaps, parameters ascending.
void checkChains(const BrepModel& model, const SurfaceMesh& mesh, const Partition& partition,
                 CheckReport& report)
{
    const auto nodeOf = [&](BrepVertexId vertex) -> NodeId { return NodeId(vertex.value); };
    for (std::uint32_t e = 0; e < model.edges.size(); ++e) {
        const BrepEdge& edge = model.edges[BrepEdgeId(e)];
        std::vector<SegmentId> chain = partition.segments[BrepEdgeId(e)];
        if (edge.isDegenerate) {
            if (!chain.empty()) report.add(mesher::nameOf(BrepEdgeId(e)) + " is a pole and has segments");
            continue;
        }
        std::sort(chain.begin(), chain.end(), [&](SegmentId a, SegmentId b) {
            return mesh.segments[a].parameter[0] < mesh.segments[b].parameter[0];
        });
        double t = edge.part.first;
        NodeId node = nodeOf(edge.first);
        bool isSound = true;
        for (const SegmentId s : chain) {
            const SurfaceSegment& segment = mesh.segments[s];
            isSound =
                isSound && segment.node[0] == node && segment.parameter[0] == t && t < segment.parameter[1];
            node = segment.node[1];
            t = segment.parameter[1];
        }
        if (!isSound || t != edge.part.last || node != nodeOf(edge.last)) {
            report.add(mesher::nameOf(BrepEdgeId(e)) + " has segments that are no chain from end to end");
        }
    }
}

void checkShell(const BrepModel& model, const SurfaceMesh& mesh, const Partition& partition,
                const BrepShell& shell, const std::string& name, CheckReport& report)
{
    if (!isClosedShell(model, shell)) return;
    IndexedMap<DirectedEdge, int> balance;
    for (const BrepShellFace& use : shell.faces) {
        for (const FacetId id : partition.facets[use.face]) {
            const SurfaceFacet& facet = mesh.facets[id];
            for (std::size_t i = 0; i < 3; ++i) {
                const NodeId a = facet.node[i], b = facet.node[(i + 1) % 3];
                balance[unorderedPair(a, b)] += (a < b) == use.isReversed ? -1 : 1;
            }
        }
    }
    for (const auto& [edge, sum] : balance) {
        if (sum == 0) continue;
        report.add(name + " is not closed between " + nameOf(edge.first) + " and " + nameOf(edge.second));
    }
}

double volumeOf(const SurfaceMesh& mesh, const Partition& partition, const BrepSolid& solid,
                const Vec3& origin)
{
    double volume = 0.0;
    for (const BrepShell& shell : solid.shells) {
        for (const BrepShellFace& use : shell.faces) {
            for (const FacetId id : partition.facets[use.face]) {
                std::array<Vec3, 3> p;
                for (std::size_t i = 0; i < 3; ++i)
                    p[i] = mesh.nodes[mesh.facets[id].node[i]].position - origin;
                volume += dot(p[0], cross(p[1], p[2])) / (use.isReversed ? -6.0 : 6.0);
            }
        }
    }
    return volume;
}

}  // namespace

bool SurfaceCheck::isValid() const { return problem().empty(); }

std::string SurfaceCheck::problem() const
{
    if (!nodes.isValid()) return nodes.problem;
    for (const FaceCheck& face : faces) {
        if (!face.report.isValid()) return face.report.problem;
    }
    return shells.problem;
}

SurfaceCheck checkSurfaceMesh(const BrepModel& model, const SurfaceMesh& mesh,
                              const SurfaceCheckOptions& options)
{
    SurfaceCheck check;
    const Partition partition(model, mesh);
    checkNodes(model, mesh, options, check.nodes);
    checkChains(model, mesh, partition, check.nodes);
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        check.faces.push_back(FaceChecker(model, mesh, partition, options, BrepFaceId(f)).run());
    }
    for (std::uint32_t s = 0; s < model.solids.size(); ++s) {
        const BrepSolidId id(s);
        for (const BrepShell& shell : model.solids[id].shells) {
            checkShell(model, mesh, partition, shell, mesher::nameOf(id), check.shells);
        }
        check.volumes.push_back(volumeOf(mesh, partition, model.solids[id], model.box.low));
    }
    for (const BrepShell& shell : model.looseShells) {
        checkShell(model, mesh, partition, shell, "a shell", check.shells);
    }
    return check;
}

}  // namespace mesher
