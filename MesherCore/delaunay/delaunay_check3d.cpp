#include "delaunay/delaunay_check3d.h"

#include "predicates/insphere.h"
#include "predicates/orient3d.h"

#include <string>
#include <unordered_map>

namespace mesher {

namespace {

std::string nameOf(TetId tet) { return "tetrahedron " + std::to_string(tet.value); }

std::string nameOf(TetFace face)
{
    return "face " + std::to_string(face.face()) + " of " + nameOf(face.tet());
}

/// Two tetrahedra on different sides of a face see its vertices in opposite senses.
bool areOppositeSides(const std::array<VertexId, 3>& a, const std::array<VertexId, 3>& b)
{
    return a == std::array{b[0], b[2], b[1]} || a == std::array{b[1], b[0], b[2]} ||
           a == std::array{b[2], b[1], b[0]};
}

bool isPositive(const Triangulation3d& mesh, TetId tet)
{
    const auto& v = mesh.tet(tet).vertex;
    return orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), mesh.position(v[3])) ==
           Sign::Positive;
}

void checkVertices(const Triangulation3d& mesh, TetId tet, CheckReport& report)
{
    const auto& v = mesh.tet(tet).vertex;
    for (unsigned i = 0; i < 4; ++i) {
        if (isGhost(v[i]) ? i != 3 : !mesh.isVertexAlive(v[i]))
            report.add(nameOf(tet) + " has a dead or misplaced vertex");
        for (unsigned j = i + 1; j < 4; ++j) {
            if (v[i] == v[j]) report.add(nameOf(tet) + " has a vertex twice");
        }
    }
}

void checkLinks(const Triangulation3d& mesh, TetId tet, CheckReport& report)
{
    for (int i = 0; i < 4; ++i) {
        const TetFace face(tet, i);
        const TetFace other = mesh.neighbour(face);
        if (other.tet().value >= mesh.tetLimit() || !mesh.isAlive(other.tet()) || other.tet() == tet) {
            report.add(nameOf(face) + " is linked to nothing");
            continue;
        }
        if (mesh.neighbour(other) != face) report.add(nameOf(face) + " is not linked back");
        if (!areOppositeSides(mesh.faceVertices(face), mesh.faceVertices(other))) {
            report.add(nameOf(face) + " is linked to a face of other vertices or sense");
        }
        if (mesh.isFaceConstrained(face) != mesh.isFaceConstrained(other)) {
            report.add(nameOf(face) + " is constrained on one side only");
        }
        const bool isOnHull = mesh.isGhostTet(tet) != mesh.isGhostTet(other.tet());
        if (mesh.region(tet) != mesh.region(other.tet()) && !mesh.isFaceConstrained(face) && !isOnHull) {
            report.add(nameOf(face) + " separates two regions and is not constrained");
        }
    }
}

/// Number of edges; beside it the constraint flags of each edge are compared.
std::uint64_t checkEdges(const Triangulation3d& mesh, CheckReport& report)
{
    std::unordered_map<std::uint64_t, bool> isConstrained;
    isConstrained.reserve(mesh.tetCount() * std::size_t{3} / 2);
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        if (!mesh.isAlive(TetId(i))) continue;
        for (int edge = 0; edge < 6; ++edge) {
            const VertexId a = mesh.vertex(TetId(i), kEdgeSlots[edge][0]);
            const VertexId b = mesh.vertex(TetId(i), kEdgeSlots[edge][1]);
            const std::uint64_t key = std::uint64_t{std::min(a, b).value} << 32 | std::max(a, b).value;
            const bool flag = mesh.isEdgeConstrained(TetId(i), edge);
            if (isConstrained.try_emplace(key, flag).first->second != flag) {
                report.add("edge (" + std::to_string(a.value) + ", " + std::to_string(b.value) +
                           ") is constrained in some of its tetrahedra only");
            }
        }
    }
    return isConstrained.size();
}

void checkIncidence(const Triangulation3d& mesh, CheckReport& report)
{
    for (std::uint32_t i = 0; i < mesh.vertexLimit(); ++i) {
        const VertexId vertex(i);
        if (!mesh.isVertexAlive(vertex)) continue;
        const TetId tet = mesh.incidentTet(vertex);
        if (!tet.isValid() || tet.value >= mesh.tetLimit() || !mesh.isAlive(tet) ||
            mesh.slotOf(tet, vertex) < 0) {
            report.add("vertex " + std::to_string(i) + " has no incident tetrahedron");
        }
    }
}

/// The sphere of a ghost tetrahedron is the half-space beyond its facet, with the circumcircle in the plane of it.
Sign conflict(const Triangulation3d& mesh, TetId tet, const Vec3& point)
{
    const auto& v = mesh.tet(tet).vertex;
    if (!mesh.isGhostTet(tet)) {
        return inspherePerturbed(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]),
                                 mesh.position(v[3]), point);
    }
    const Sign side = orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), point);
    return side != Sign::Zero ? side : conflict(mesh, mesh.neighbour(tet, 3).tet(), point);
}

bool hasVertex(const Triangulation3d& mesh, TetId tet, VertexId vertex)
{
    return mesh.slotOf(tet, vertex) >= 0;
}

}  // namespace

CheckReport checkTopology3d(const Triangulation3d& mesh)
{
    CheckReport report;
    if (mesh.tetCount() == 0) return report;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet)) continue;
        checkVertices(mesh, tet, report);
        if (!report.isValid()) return report;
        checkLinks(mesh, tet, report);
        if (!mesh.isGhostTet(tet) && !isPositive(mesh, tet))
            report.add(nameOf(tet) + " is not positively oriented");
        if ((mesh.flags(tet) & (tet_flag::kInCavity | tet_flag::kAllowed)) != 0) {
            report.add(nameOf(tet) + " kept a scratch mark");
        }
    }
    checkIncidence(mesh, report);
    // On the 3-sphere V - E + F - T = 0 with F = 2 T, the ghost counted as a vertex.
    const std::uint64_t edges = checkEdges(mesh, report);
    if (mesh.vertexCount() + 1 + std::uint64_t{mesh.tetCount()} != edges) {
        report.add("Euler characteristic is not 0: " + std::to_string(mesh.vertexCount() + 1) +
                   " vertices, " + std::to_string(edges) + " edges, " + std::to_string(mesh.tetCount()) +
                   " tetrahedra");
    }
    return report;
}

CheckReport checkDelaunay3d(const Triangulation3d& mesh, DelaunayScope scope)
{
    CheckReport report;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet)) continue;
        if (scope == DelaunayScope::Global) {
            for (std::uint32_t j = 0; j < mesh.vertexLimit(); ++j) {
                const VertexId vertex(j);
                if (!mesh.isVertexAlive(vertex) || hasVertex(mesh, tet, vertex)) continue;
                if (conflict(mesh, tet, mesh.position(vertex)) == Sign::Positive) {
                    report.add("vertex " + std::to_string(j) + " lies in the sphere of " + nameOf(tet));
                }
            }
            continue;
        }
        for (int face = 0; face < 4; ++face) {
            const TetFace other = mesh.neighbour(tet, face);
            const VertexId apex = mesh.vertex(other.tet(), other.face());
            if (mesh.isFaceConstrained(other) || isGhost(apex)) continue;
            if (conflict(mesh, tet, mesh.position(apex)) == Sign::Positive) {
                report.add(nameOf(TetFace(tet, face)) + " is not locally Delaunay");
            }
        }
    }
    return report;
}

}  // namespace mesher
