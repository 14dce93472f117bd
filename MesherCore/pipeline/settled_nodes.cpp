#include "pipeline/settled_nodes.h"

#include "predicates/orient3d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace mesher {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Of the largest coordinate: what a point of a plane or curve is off for the rounding of its evaluation.
constexpr double kNoise = 16.0 * kEpsilon;
/// The same of a coordinate that is zero, as the cosine of a right angle.
constexpr double kNoiseOfZero = 4.0 * kEpsilon;

using Axis = double Vec3::*;
constexpr std::array<Axis, 3> kAxes = {&Vec3::x, &Vec3::y, &Vec3::z};

/// The coordinates that all points of an entity have in common, by axis.
using Common = std::array<std::optional<double>, 3>;

void adopt(Common& target, const Common& source)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (!target[k]) target[k] = source[k];
    }
}

double largestOf(const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

/// What a coordinate is that some points of the entity give in exactly the same way: zero if it is one to within noise, what
/// the vertices have where they agree, else the value itself.
double settledValue(double value, Axis axis, double scale, const std::vector<Vec3>& vertices)
{
    if (std::abs(value) <= kNoise * scale) return 0.0;
    if (vertices.empty()) return value;
    const double first = vertices.front().*axis;
    const bool agree =
        std::all_of(vertices.begin(), vertices.end(), [&](const Vec3& v) { return v.*axis == first; });
    return agree && std::abs(first - value) <= kNoise * scale ? first : value;
}

/// Points of a line or conic at which a coordinate that is the same tells that it is so everywhere.
std::vector<CurvePoint> witnesses(const BrepEdge& edge)
{
    const Curve& curve = *edge.curve;
    const double first = edge.part.first;
    if (curve.kind() == CurveKind::Line) return {curve.evaluate(first)};
    if (curve.kind() == CurveKind::Circle || curve.kind() == CurveKind::Ellipse)
        return {curve.evaluate(first), curve.evaluate(first + 0.5 * std::numbers::pi)};
    return {};
}

class NodeSettler
{
public:
    NodeSettler(ClassifiedMesh& mesh, const BrepModel& model)
        : mesh_(mesh),
          model_(model),
          faceScale_(model.faces.size(), 0.0),
          edgeScale_(model.edges.size(), 0.0),
          vertexScale_(model.vertices.size(), 0.0),
          ofFace_(model.faces.size()),
          ofEdge_(model.edges.size()),
          ofVertex_(model.vertices.size()),
          before_(mesh.nodes.size())
    {
    }

    SettledNodes settle()
    {
        measure();
        for (std::uint32_t i = 0; i < model_.faces.size(); ++i) askFace(BrepFaceId(i));
        for (std::uint32_t i = 0; i < model_.edges.size(); ++i) askEdge(BrepEdgeId(i));
        for (std::uint32_t i = 0; i < mesh_.nodes.size(); ++i) settle(NodeId(i));
        while (keepOrientation()) {
        }
        SettledNodes result;
        for (std::uint32_t i = 0; i < mesh_.nodes.size(); ++i)
            result.settled += before_[NodeId(i)].has_value() ? 1 : 0;
        result.kept = kept_;
        return result;
    }

private:
    /// The largest coordinates of what the mesh has on each entity.
    void measure()
    {
        const auto include = [&](double& scale, const auto& element) {
            for (const NodeId node : element.node)
                scale = std::max(scale, largestOf(mesh_.nodes[node].position));
        };
        for (const MeshElement<3>& triangle : mesh_.triangles) {
            if (isOn(triangle.entity, 2, faceScale_.size()))
                include(faceScale_[BrepFaceId(triangle.entity.index)], triangle);
        }
        for (const MeshElement<2>& line : mesh_.lines) {
            if (isOn(line.entity, 1, edgeScale_.size()))
                include(edgeScale_[BrepEdgeId(line.entity.index)], line);
        }
        for (std::uint32_t i = 0; i < model_.edges.size(); ++i) {
            const BrepEdge& edge = model_.edges[BrepEdgeId(i)];
            for (const BrepVertexId v : {edge.first, edge.last})
                vertexScale_[v] = std::max(vertexScale_[v], edgeScale_[BrepEdgeId(i)]);
        }
    }

    [[nodiscard]] static bool isOn(EntityRef entity, std::uint8_t dimension, std::size_t count)
    {
        return entity.dimension == dimension && entity.index < count;
    }

    void askFace(BrepFaceId id)
    {
        const BrepFace& face = model_.faces[id];
        if (faceScale_[id] == 0.0) return;
        if (const std::optional<PlaneFrame> frame = face.surface->planeFrame())
            askPlane(*frame, faceScale_[id], verticesOf(face), ofFace_[id]);
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) adopt(ofEdge_[coedge.edge], ofFace_[id]);
        }
        for (const BrepEdgeId edge : face.embeddedEdges) adopt(ofEdge_[edge], ofFace_[id]);
        for (const BrepVertexId vertex : face.embeddedVertices) adopt(ofVertex_[vertex], ofFace_[id]);
    }

    static void askPlane(const PlaneFrame& frame, double scale, const std::vector<Vec3>& vertices,
                         Common& common)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& n = frame.normal;
            const double tilt = std::max(std::abs(n.*kAxes[(k + 1) % 3]), std::abs(n.*kAxes[(k + 2) % 3]));
            if (tilt <= kNoiseOfZero)
                common[k] = settledValue(frame.origin.*kAxes[k], kAxes[k], scale, vertices);
        }
    }

    [[nodiscard]] std::vector<Vec3> verticesOf(const BrepFace& face) const
    {
        std::vector<Vec3> vertices;
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges)
                vertices.push_back(model_.vertices[model_.edges[coedge.edge].first].position);
        }
        return vertices;
    }

    void askEdge(BrepEdgeId id)
    {
        const BrepEdge& edge = model_.edges[id];
        if (edge.curve != nullptr && edgeScale_[id] > 0.0) {
            const std::vector<CurvePoint> points = witnesses(edge);
            const std::vector<Vec3> ends = {model_.vertices[edge.first].position,
                                            model_.vertices[edge.last].position};
            for (std::size_t k = 0; k < 3; ++k) {
                const bool isLevel = std::all_of(points.begin(), points.end(), [&](const CurvePoint& point) {
                    return std::abs(point.d1.*kAxes[k]) <= kNoiseOfZero * length(point.d1);
                });
                if (points.empty() || !isLevel || ofEdge_[id][k]) continue;
                ofEdge_[id][k] =
                    settledValue(points.front().position.*kAxes[k], kAxes[k], edgeScale_[id], ends);
            }
        }
        for (const BrepVertexId vertex : {edge.first, edge.last}) adopt(ofVertex_[vertex], ofEdge_[id]);
    }

    void settle(NodeId id)
    {
        const EntityRef entity = mesh_.nodes[id].entity;
        if (isOn(entity, 2, ofFace_.size())) {
            settle(id, ofFace_[BrepFaceId(entity.index)], faceScale_[BrepFaceId(entity.index)]);
        } else if (isOn(entity, 1, ofEdge_.size())) {
            settle(id, ofEdge_[BrepEdgeId(entity.index)], edgeScale_[BrepEdgeId(entity.index)]);
        } else if (isOn(entity, 0, ofVertex_.size())) {
            settle(id, ofVertex_[BrepVertexId(entity.index)], vertexScale_[BrepVertexId(entity.index)]);
        }
    }

    void settle(NodeId id, const Common& common, double scale)
    {
        Vec3 position = mesh_.nodes[id].position;
        for (std::size_t k = 0; k < 3; ++k) {
            double& coordinate = position.*kAxes[k];
            if (common[k] && std::abs(coordinate - *common[k]) <= kNoise * scale) {
                coordinate = *common[k];
            } else if (std::abs(coordinate) <= kNoiseOfZero * scale) {
                coordinate = 0.0;
            }
        }
        if (position == mesh_.nodes[id].position) return;
        before_[id] = mesh_.nodes[id].position;
        mesh_.nodes[id].position = position;
    }

    /// Brings back the nodes of tetrahedra that are not positive any more; whether there were any.
    bool keepOrientation()
    {
        bool isChanged = false;
        for (const MeshElement<4>& tet : mesh_.tets) {
            const auto isMoved = [&](NodeId node) { return before_[node].has_value(); };
            if (std::none_of(tet.node.begin(), tet.node.end(), isMoved)) continue;
            const auto at = [&](std::size_t i) { return mesh_.nodes[tet.node[i]].position; };
            if (orient3d(at(0), at(1), at(2), at(3)) == Sign::Positive) continue;
            for (const NodeId node : tet.node) {
                if (!isMoved(node)) continue;
                mesh_.nodes[node].position = *before_[node];
                before_[node].reset();
                ++kept_;
                isChanged = true;
            }
        }
        return isChanged;
    }

    ClassifiedMesh& mesh_;
    const BrepModel& model_;
    IdVector<BrepFaceId, double> faceScale_;
    IdVector<BrepEdgeId, double> edgeScale_;
    IdVector<BrepVertexId, double> vertexScale_;
    IdVector<BrepFaceId, Common> ofFace_;
    IdVector<BrepEdgeId, Common> ofEdge_;
    IdVector<BrepVertexId, Common> ofVertex_;
    IdVector<NodeId, std::optional<Vec3>> before_;  ///< of nodes that were moved
    std::uint64_t kept_ = 0;
};

}  // namespace

SettledNodes settleNodes(ClassifiedMesh& mesh, const BrepModel& model)
{
    return NodeSettler(mesh, model).settle();
}

}  // namespace mesher
