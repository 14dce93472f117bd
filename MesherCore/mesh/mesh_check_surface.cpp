#include "mesh/mesh_check_steps.h"

#include "base/box.h"
#include "predicates/orient2d.h"

#include <cmath>
#include <span>

namespace mesher::detail {

namespace {

/// Nodes nearer to their face's plane than this part of the face's size make the face a plane.
constexpr double kPlanarity = 1e-9;

Vec3 doubleArea(const ClassifiedMesh& mesh, const MeshElement<3>& triangle)
{
    const Vec3 origin = mesh.nodes[triangle.node[0]].position;
    return cross(mesh.nodes[triangle.node[1]].position - origin,
                 mesh.nodes[triangle.node[2]].position - origin);
}

/// What the triangles of one face have in common.
struct FaceSummary
{
    Vec3 normal;  ///< sum of double area vectors
    Box3 box;
    Vec3 origin;
    double area = 0.0;
    bool isPlanar = true;
};

std::map<std::uint32_t, FaceSummary> summarise(const ClassifiedMesh& mesh)
{
    std::map<std::uint32_t, FaceSummary> faces;
    for (const MeshElement<3>& triangle : mesh.triangles) {
        FaceSummary& face = faces[triangle.entity.index];
        const Vec3 area = doubleArea(mesh, triangle);
        face.normal = face.normal + area;
        face.area += 0.5 * length(area);
        for (const NodeId node : triangle.node) face.box.include(mesh.nodes[node].position);
        face.origin = mesh.nodes[triangle.node[0]].position;
    }
    for (const MeshElement<3>& triangle : mesh.triangles) {
        FaceSummary& face = faces[triangle.entity.index];
        const double tolerance = kPlanarity * length(face.box.extent()) * length(face.normal);
        for (const NodeId node : triangle.node) {
            const double height = dot(mesh.nodes[node].position - face.origin, face.normal);
            if (!(std::abs(height) <= tolerance)) face.isPlanar = false;
        }
    }
    return faces;
}

/// Exact where the face lies in a plane of constant z.
Sign orientationInFace(const ClassifiedMesh& mesh, const MeshElement<3>& triangle, const FaceSummary& face)
{
    const Vec3& a = mesh.nodes[triangle.node[0]].position;
    const Vec3& b = mesh.nodes[triangle.node[1]].position;
    const Vec3& c = mesh.nodes[triangle.node[2]].position;
    if (face.box.low.z == face.box.high.z) {
        return signOf(face.normal.z) * orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
    }
    return signOf(dot(doubleArea(mesh, triangle), face.normal));
}

void checkOrientation(const ClassifiedMesh& mesh, const std::map<std::uint32_t, FaceSummary>& faces,
                      MeshCheckReport& report)
{
    for (const MeshElement<3>& triangle : mesh.triangles) {
        const FaceSummary& face = faces.at(triangle.entity.index);
        if (!face.isPlanar) {
            if (squaredLength(doubleArea(mesh, triangle)) == 0.0) ++report.degenerate;
            continue;
        }
        const Sign sign = orientationInFace(mesh, triangle, face);
        if (sign == Sign::Negative) ++report.inverted;
        if (sign == Sign::Zero) ++report.degenerate;
    }
}

std::vector<SideRecord<2>> edgesOfTriangles(const ClassifiedMesh& mesh)
{
    std::vector<SideRecord<2>> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& node = mesh.triangles[i].node;
        for (std::uint8_t k = 0; k < 3; ++k) {
            edges.push_back({sortedKey<2>({node[k], node[(k + 1u) % 3u]}), i, k});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

bool runsForward(const ClassifiedMesh& mesh, const SideRecord<2>& edge)
{
    return mesh.triangles[edge.owner].node[edge.side].value == edge.key[0];
}

/// Two triangles of one face that run the same way along their common edge lie on the same side of it (or one is turned).
void checkEdgeInFace(const ClassifiedMesh& mesh, std::span<const SideRecord<2>> uses, MeshCheckReport& report)
{
    if (uses.size() > 2) {
        ++report.overSharedSides;
    } else if (uses.size() == 2 && runsForward(mesh, uses[0]) == runsForward(mesh, uses[1])) {
        ++report.foldedSides;
    }
}

/// The records of one edge, grouped by face.
void checkEdge(const ClassifiedMesh& mesh, std::vector<SideRecord<2>> uses, bool hasLine,
               MeshCheckReport& report)
{
    const auto faceOf = [&](const SideRecord<2>& use) { return mesh.triangles[use.owner].entity.index; };
    std::stable_sort(uses.begin(), uses.end(),
                     [&](const auto& a, const auto& b) { return faceOf(a) < faceOf(b); });
    std::size_t faceCount = 0;
    for (std::size_t first = 0; first < uses.size(); ++faceCount) {
        std::size_t last = first + 1;
        while (last < uses.size() && faceOf(uses[last]) == faceOf(uses[first])) ++last;
        checkEdgeInFace(mesh, {uses.data() + first, last - first}, report);
        first = last;
    }
    if (hasLine) return;
    if (uses.size() == 1) ++report.boundaryWithoutElement;
    if (faceCount > 1) ++report.interfaceWithoutElement;
}

}  // namespace

void checkSurface(const ClassifiedMesh& mesh, MeshCheckReport& report)
{
    if (mesh.triangles.empty()) return;
    const std::map<std::uint32_t, FaceSummary> faces = summarise(mesh);
    for (const auto& [index, face] : faces) {
        report.areaOfFace[index] = face.area;
        report.area += face.area;
    }
    checkOrientation(mesh, faces, report);

    const std::vector<SideRecord<2>> lines = sortedRecords(mesh.lines);
    const std::vector<SideRecord<2>> edges = edgesOfTriangles(mesh);
    // Files of solids have lines where groups of edges are wished for.
    const bool wantsLines = mesh.tets.empty() || !mesh.lines.empty();
    forRuns<2>(edges, [&](std::size_t first, std::size_t last) {
        const bool hasLine = !wantsLines || containsKey(lines, edges[first].key);
        const std::span<const SideRecord<2>> uses(edges.data() + first, last - first);
        const bool isInsideFace =
            uses.size() == 2 && mesh.triangles[uses[0].owner].entity == mesh.triangles[uses[1].owner].entity;
        if (isInsideFace) {
            checkEdgeInFace(mesh, uses, report);
        } else {
            checkEdge(mesh, {uses.begin(), uses.end()}, hasLine, report);
        }
    });
    for (const SideRecord<2>& line : lines) {
        if (!containsKey(edges, line.key)) ++report.linesNotEdges;
    }
}

}  // namespace mesher::detail
