#include "improvement/improvement_check.h"

#include "improvement/dihedral_score.h"
#include "mesh/mesh_check.h"
#include "quality/quality_statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace mesher {

namespace {

constexpr double kRounding = 1e-9;  // relative
constexpr double kDegrees = 180.0 / std::numbers::pi;

std::vector<double> sortedScores(const ClassifiedMesh& mesh)
{
    std::vector<double> scores;
    for (const auto& tet : mesh.tets) scores.push_back(dihedralScore(cornersOf(mesh, tet)));
    std::sort(scores.begin(), scores.end());
    return scores;
}

/// Lexicographically; a list that ends is better than one that goes on, as all that is worse is the same.
void checkScores(const ClassifiedMesh& before, const ClassifiedMesh& after, CheckReport& report)
{
    const std::vector<double> old = sortedScores(before);
    const std::vector<double> now = sortedScores(after);
    for (std::size_t i = 0; i < std::min(old.size(), now.size()); ++i) {
        if (now[i] > old[i]) return;
        if (now[i] == old[i]) continue;
        report.add("the score number " + std::to_string(i) + " of the worst has fallen");
        return;
    }
    if (now.size() > old.size()) report.add("there are more tetrahedra, and none is better");
}

std::set<NodeId> boundaryNodes(const ClassifiedMesh& mesh)
{
    std::set<NodeId> nodes;
    for (const auto& triangle : mesh.triangles) nodes.insert(triangle.node.begin(), triangle.node.end());
    return nodes;
}

double distanceFrom(const BrepFace& face, const Vec3& point) { return face.surface->project(point).distance; }

/// Of a node of an edge from the faces beside it.
void checkAdjoining(const BrepModel& model, const MeshNode& old, const MeshNode& now,
                    const std::vector<std::uint32_t>& faces, double allowed, CheckReport& report)
{
    for (const std::uint32_t f : faces) {
        const BrepFace& face = model.faces[BrepFaceId(f)];
        const double distance = distanceFrom(face, now.position);
        if (distance <= allowed || distance <= distanceFrom(face, old.position)) continue;
        report.add("a node of " + nameOf(now.entity) + " is off " + mesher::nameOf(BrepFaceId(f)));
    }
}

/// Faces that meet in each edge of the model.
std::map<std::uint32_t, std::vector<std::uint32_t>> facesOfEdges(const BrepModel& model)
{
    std::map<std::uint32_t, std::vector<std::uint32_t>> faces;
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        for (const BrepLoop& loop : model.faces[BrepFaceId(f)].loops) {
            for (const BrepCoedge& coedge : loop.coedges) faces[coedge.edge.value].push_back(f);
        }
    }
    return faces;
}

void checkNode(const BrepModel& model, const MeshNode& old, const MeshNode& now,
               const std::map<std::uint32_t, std::vector<std::uint32_t>>& facesOfEdge,
               const ImprovementCheckOptions& options, CheckReport& report)
{
    if (!(old.entity == now.entity)) {
        report.add("a node of " + nameOf(old.entity) + " is on another entity");
        return;
    }
    if (old.position == now.position) return;
    const std::string name = nameOf(now.entity);
    if (now.entity.dimension == 0) report.add("the node at " + name + " has moved");
    if (now.entity.dimension == 1) {
        const BrepEdge& edge = model.edges[BrepEdgeId(now.entity.index)];
        if (length(edge.curve->position(now.parameters.x) - now.position) > options.nodeDistance)
            report.add("a node of " + name + " is off its curve");
        checkAdjoining(model, old, now, facesOfEdge.at(now.entity.index),
                       std::max(options.nodeDistance, edge.tolerance), report);
    }
    if (now.entity.dimension == 2) {
        const BrepFace& face = model.faces[BrepFaceId(now.entity.index)];
        if (length(face.surface->position(now.parameters) - now.position) > options.nodeDistance)
            report.add("a node of " + name + " is off its surface");
    }
}

void checkNodes(const ClassifiedMesh& before, const ClassifiedMesh& after, const BrepModel& model,
                const ImprovementCheckOptions& options, CheckReport& report)
{
    const std::set<NodeId> old = boundaryNodes(before);
    const std::set<NodeId> now = boundaryNodes(after);
    if (old.size() != now.size()) {
        report.add("nodes of the boundary have come or gone");
        return;
    }
    const auto facesOfEdge = facesOfEdges(model);
    for (auto a = old.begin(), b = now.begin(); a != old.end(); ++a, ++b)
        checkNode(model, before.nodes[*a], after.nodes[*b], facesOfEdge, options, report);
}

/// What the triangles of one face come to.
struct FaceFacts
{
    std::size_t triangles = 0;
    std::set<NodeId> nodes;
    std::set<std::pair<NodeId, NodeId>> sides;
    double area = 0.0;
    double leastAngle = 180.0;  ///< degrees
    double agreement =
        1.0;  ///< least cosine between the normals of triangle and surface, by the more frequent side
    double sag = 0.0;
};

/// Positive cosines are along du x dv.
std::array<double, 3> cosinesOf(const BrepFace& face, std::uint32_t f, const ClassifiedMesh& mesh,
                                const MeshElement<3>& triangle)
{
    const TriangleCorners p = cornersOf(mesh, triangle);
    const Vec3 own = cross(p[1] - p[0], p[2] - p[0]);
    std::array<double, 3> cosines{1.0, 1.0, 1.0};
    for (std::size_t k = 0; k < 3; ++k) {
        const MeshNode& node = mesh.nodes[triangle.node[k]];
        const Vec2 uv = node.entity == EntityRef{2, f} ? node.parameters
                                                       : face.surface->project(node.position).parameters;
        const SurfacePoint point = face.surface->evaluate(uv);
        const double size = length(point.normal());
        if (size > kRounding * length(point.du) * length(point.dv))
            cosines[k] = dot(own, point.normal()) / (length(own) * size);
    }
    return cosines;
}

std::map<std::uint32_t, FaceFacts> factsOf(const ClassifiedMesh& mesh, const BrepModel& model)
{
    std::map<std::uint32_t, FaceFacts> facts;
    std::map<std::uint32_t, double> side;
    for (const auto& triangle : mesh.triangles) {
        const std::uint32_t f = triangle.entity.index;
        const BrepFace& face = model.faces[BrepFaceId(f)];
        FaceFacts& own = facts[f];
        ++own.triangles;
        const TriangleCorners p = cornersOf(mesh, triangle);
        own.area += 0.5 * length(cross(p[1] - p[0], p[2] - p[0]));
        const std::array<double, 3> cosines = cosinesOf(face, f, mesh, triangle);
        if (!side.contains(f)) side[f] = cosines[0] + cosines[1] + cosines[2] < 0.0 ? -1.0 : 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const NodeId a = triangle.node[k];
            const NodeId b = triangle.node[(k + 1) % 3];
            own.nodes.insert(a);
            own.sides.insert(std::minmax(a, b));
            own.agreement = std::min(own.agreement, side[f] * cosines[k]);
            own.sag = std::max(own.sag, distanceFrom(face, 0.5 * (p[k] + p[(k + 1) % 3])));
            const Vec3 u = p[(k + 1) % 3] - p[k];
            const Vec3 v = p[(k + 2) % 3] - p[k];
            own.leastAngle = std::min(own.leastAngle, kDegrees * std::atan2(length(cross(u, v)), dot(u, v)));
        }
    }
    return facts;
}

void checkFace(const std::string& name, const FaceFacts& old, const FaceFacts& now,
               const ImprovementCheckOptions& options, CheckReport& report)
{
    if (old.triangles != now.triangles || old.nodes.size() != now.nodes.size() ||
        old.sides.size() != now.sides.size()) {
        report.add(name + " has another number of triangles, nodes or sides");
    }
    constexpr double kSquaredGrowth = BoundaryGeometry::kGrowth * BoundaryGeometry::kGrowth;
    if (1.0 - now.agreement > kSquaredGrowth * (1.0 - old.agreement) + 1e-6)
        report.add(name + " has triangles that follow its normals less");
    if (now.sag > options.sagGrowth * old.sag + options.nodeDistance)
        report.add(name + " has sides further from it");
    if (now.leastAngle < std::min(old.leastAngle, BoundaryGeometry::kLeastFacetAngle) - 1e-6)
        report.add(name + " has a smaller angle");
}

void checkLines(const ClassifiedMesh& before, const ClassifiedMesh& after, CheckReport& report)
{
    if (before.lines.size() != after.lines.size() || before.points.size() != after.points.size()) {
        report.add("lines or points have come or gone");
        return;
    }
    for (std::size_t i = 0; i < before.lines.size(); ++i) {
        if (before.lines[i].entity != after.lines[i].entity) report.add("a line is on another edge");
    }
}

}  // namespace

CheckReport checkImprovement(const ClassifiedMesh& before, const ClassifiedMesh& after,
                             const BrepModel& model, const ImprovementCheckOptions& options)
{
    CheckReport report;
    const MeshCheckReport old = checkMesh(before);
    const MeshCheckReport now = checkMesh(after);
    if (old.isValid()) {
        for (const std::string& problem : now.problems()) report.add(problem);
    }
    checkScores(before, after, report);
    checkNodes(before, after, model, options, report);
    checkLines(before, after, report);
    const auto oldFaces = factsOf(before, model);
    const auto newFaces = factsOf(after, model);
    double gap = kRounding * old.volume;
    for (const auto& [f, facts] : oldFaces) {
        const auto found = newFaces.find(f);
        if (found == newFaces.end()) {
            report.add(mesher::nameOf(BrepFaceId(f)) + " has lost its triangles");
            continue;
        }
        checkFace(mesher::nameOf(BrepFaceId(f)), facts, found->second, options, report);
        gap += facts.area * (facts.sag + found->second.sag);
    }
    for (const auto& [solid, volume] : old.volumeOfSolid) {
        const auto found = now.volumeOfSolid.find(solid);
        if (found == now.volumeOfSolid.end() || !(std::abs(found->second - volume) <= gap))
            report.add(mesher::nameOf(BrepSolidId(solid)) + " has another volume");
    }
    return report;
}

}  // namespace mesher
