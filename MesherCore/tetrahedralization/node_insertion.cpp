#include "tetrahedralization/node_insertion.h"

#include "predicates/coordinate_range.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mesher {

namespace {

/// Fewer nodes are tetrahedralized at once whatever their places; more on a surface take scaffold points.
constexpr std::size_t kLeastForScaffold = 5000;

/// The corners of a box a good deal larger than the points, none two at the same height, lest many be cospherical.
std::vector<Vec3> boxCorners(const Box3& box)
{
    const Vec3 extent = box.extent();
    const double margin = 0.6 * std::max({extent.x, extent.y, extent.z, 0x1p-20 * length(box.high)});
    std::vector<Vec3> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const double grow = margin * (1.0 + 0.03 * i);
        corners.push_back({(i & 1u) != 0 ? box.high.x + grow : box.low.x - 1.01 * grow,
                           (i & 2u) != 0 ? box.high.y + 1.02 * grow : box.low.y - 1.03 * grow,
                           (i & 4u) != 0 ? box.high.z + 1.04 * grow : box.low.z - 1.05 * grow});
    }
    return corners;
}

std::string nameOfNode(const MeshNode& node, std::uint32_t index)
{
    const std::string name = nameOf(node.entity);
    return name.empty() ? "node " + std::to_string(index) : name;
}

Result<void> mapNodes(const SurfaceMesh& surface, const std::vector<VertexId>& vertices,
                      ConstrainedTetrahedralization& tets)
{
    tets.nodeOf.resize(tets.mesh().vertexLimit());
    tets.vertexOf.resize(surface.nodes.size());
    for (std::uint32_t i = 0; i < surface.nodes.size(); ++i) {
        const NodeId node(i);
        const VertexId vertex = vertices[i];
        if (tets.nodeOf[vertex].isValid()) {
            const NodeId other = tets.nodeOf[vertex];
            return Error{ErrorCode::DuplicatePoint, "two nodes of the surface mesh are at one place",
                         nameOfNode(surface.nodes[other], other.value) + " and " +
                             nameOfNode(surface.nodes[node], i),
                         surface.nodes[node].position, "merge the vertices of the model, or repair it"};
        }
        tets.nodeOf[vertex] = node;
        tets.vertexOf[node] = vertex;
        tets.mesh().setClassification(vertex, vertexClassOf(surface.nodes[node]));
    }
    return {};
}

}  // namespace

VertexClass vertexClassOf(const MeshNode& node)
{
    VertexClass result;
    result.dimension = node.entity.dimension & 7u;
    if (node.entity.index != EntityRef::kNone) result.entity = node.entity.index & VertexClass::kNoEntity;
    return result;
}

Result<void> insertNodes(const SurfaceMesh& surface, const TetrahedralizationOptions& options,
                         RunContext& context, Tetrahedralization& result)
{
    std::vector<Vec3> points;
    points.reserve(surface.nodes.size() + 8);
    for (const MeshNode& node : surface.nodes) points.push_back(node.position);
    const auto scaling = PowerOfTwoScaling::forPoints(points);
    if (!scaling) return scaling.error();
    std::size_t rounded = 0;
    for (Vec3& point : points) point = scaling->toKernel(point, rounded);
    ConstrainedTetrahedralization& tets = result.tets;
    tets.scale = std::ldexp(1.0, scaling->exponent());
    tets.delaunay = std::make_unique<Delaunay3d>(context.seed());

    BulkInsertionOptions3d bulk;
    if (options.scaffold != SurfaceScaffold::None && points.size() >= kLeastForScaffold)
        bulk.scaffold = ScaffoldPolicy::Automatic;
    const std::vector<Vec3> corners = boxCorners(Box3::of(points));
    points.insert(points.end(), corners.begin(), corners.end());
    const auto inserted = tets.delaunay->insertPoints(points, bulk, context);
    if (!inserted) return inserted.error();
    result.counts.nodes = static_cast<std::uint32_t>(surface.nodes.size());
    result.counts.boxPoints = static_cast<std::uint32_t>(corners.size());
    result.counts.scaffoldPoints = inserted->scaffoldPoints;
    result.stopReason = inserted->stopReason;
    if (inserted->stopReason != StopReason::Done) return {};
    VertexClass scaffold;
    scaffold.scaffold = 1;
    for (std::size_t i = surface.nodes.size(); i < points.size(); ++i)
        tets.mesh().setClassification(inserted->vertex[i], scaffold);
    return mapNodes(surface, inserted->vertex, tets);
}

}  // namespace mesher
