#include "io/visible_facets.h"

#include "base/box.h"

#include <algorithm>
#include <utility>

namespace mesher {

namespace {

double coordinate(const Vec3& p, std::size_t axis) { return axis == 0 ? p.x : (axis == 1 ? p.y : p.z); }

using Nodes = std::array<NodeId, 3>;

Nodes sorted(Nodes nodes)
{
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

template <std::size_t N>
bool isBehind(const ClassifiedMesh& mesh, const MeshElement<N>& element, const CutPlane& plane,
              bool isEyeAbove)
{
    double sum = 0.0;
    for (const NodeId node : element.node) sum += coordinate(mesh.nodes[node].position, plane.axis);
    const double middle = sum / static_cast<double>(N);
    return isEyeAbove ? middle <= plane.at : middle >= plane.at;
}

/// The sides that belong to one of the chosen tetrahedra only, as of their solid.
template <class IsChosen>
std::vector<VisibleFacet> outsideOf(const ClassifiedMesh& mesh, IsChosen isChosen)
{
    std::vector<std::pair<Nodes, EntityRef>> sides;
    for (const MeshElement<4>& tet : mesh.tets) {
        if (!isChosen(tet)) continue;
        const auto& [a, b, c, d] = tet.node;
        for (const Nodes& side : {Nodes{b, c, d}, Nodes{a, c, d}, Nodes{a, b, d}, Nodes{a, b, c}}) {
            sides.emplace_back(sorted(side), tet.entity);
        }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<VisibleFacet> facets;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t next = i + 1;
        while (next < sides.size() && sides[next].first == sides[i].first) ++next;
        if (next == i + 1) facets.push_back({sides[i].first, sides[i].second});
        i = next;
    }
    return facets;
}

/// Where a side is a triangle of the mesh, it is of that triangle's face.
void nameFaces(const ClassifiedMesh& mesh, std::vector<VisibleFacet>& facets)
{
    std::vector<std::pair<Nodes, EntityRef>> faces;
    faces.reserve(mesh.triangles.size());
    for (const MeshElement<3>& triangle : mesh.triangles) {
        faces.emplace_back(sorted(triangle.node), triangle.entity);
    }
    std::sort(faces.begin(), faces.end());
    for (VisibleFacet& facet : facets) {
        const auto at =
            std::lower_bound(faces.begin(), faces.end(), facet.node,
                             [](const auto& face, const Nodes& nodes) { return face.first < nodes; });
        if (at != faces.end() && at->first == facet.node) facet.entity = at->second;
    }
}

}  // namespace

CutPlane cutPlaneOf(const ClassifiedMesh& mesh, const DrawingOptions& options)
{
    Box3 box;
    for (const MeshNode& node : mesh.nodes) box.include(node.position);
    CutPlane plane;
    plane.axis = options.cutAxis.value_or(box.extent().x < box.extent().y ? 0 : 1);
    const double middle = 0.5 * (coordinate(box.low, plane.axis) + coordinate(box.high, plane.axis));
    plane.at = options.cutAt.value_or(middle);
    return plane;
}

std::vector<VisibleFacet> surfaceOf(const ClassifiedMesh& mesh)
{
    if (mesh.triangles.empty()) return outsideOf(mesh, [](const MeshElement<4>&) { return true; });
    std::vector<VisibleFacet> facets;
    for (const MeshElement<3>& triangle : mesh.triangles) facets.push_back({triangle.node, triangle.entity});
    return facets;
}

std::vector<VisibleFacet> cutSurfaceOf(const ClassifiedMesh& mesh, const CutPlane& plane,
                                       const Vec3& towardsEye)
{
    const bool isEyeAbove = coordinate(towardsEye, plane.axis) > 0.0;
    const auto isKept = [&](const auto& element) { return isBehind(mesh, element, plane, isEyeAbove); };
    if (!mesh.tets.empty()) {
        std::vector<VisibleFacet> facets = outsideOf(mesh, isKept);
        nameFaces(mesh, facets);
        return facets;
    }
    std::vector<VisibleFacet> facets;
    for (const MeshElement<3>& triangle : mesh.triangles) {
        if (isKept(triangle)) facets.push_back({triangle.node, triangle.entity});
    }
    return facets;
}

}  // namespace mesher
