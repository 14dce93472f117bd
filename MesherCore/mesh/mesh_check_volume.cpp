#include "mesh/mesh_check_steps.h"

#include "predicates/orient3d.h"

#include <cmath>
#include <span>

namespace mesher::detail {

namespace {

/// The corners of the side opposite to each corner, seen counterclockwise from outside a positive tetrahedron.
constexpr std::array<std::array<std::uint8_t, 3>, 4> kOutwardSides = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

std::array<NodeId, 3> sideOf(const MeshElement<4>& tet, std::uint8_t side)
{
    const auto& corner = kOutwardSides[side];
    return {tet.node[corner[0]], tet.node[corner[1]], tet.node[corner[2]]};
}

/// Whether two sequences of the same three nodes run the same way round.
bool isSameTurn(const std::array<NodeId, 3>& a, const std::array<NodeId, 3>& b)
{
    for (std::size_t shift = 0; shift < 3; ++shift) {
        if (a[0] == b[shift]) return a[1] == b[(shift + 1) % 3];
    }
    return false;
}

double sixfoldVolume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return dot(cross(b - a, c - a), d - a);
}

struct VolumeCheck
{
    const ClassifiedMesh& mesh;
    MeshCheckReport& report;
    std::vector<SideRecord<3>> triangles;
    std::vector<Sign> sign;
    std::vector<std::array<NodeId, 3>> boundary;  ///< looking outward

    [[nodiscard]] const Vec3& at(NodeId node) const { return mesh.nodes[node].position; }

    void measure()
    {
        for (const MeshElement<4>& tet : mesh.tets) {
            const auto& n = tet.node;
            sign.push_back(orient3d(at(n[0]), at(n[1]), at(n[2]), at(n[3])));
            if (sign.back() == Sign::Negative) ++report.inverted;
            if (sign.back() == Sign::Zero) ++report.degenerate;
            const double volume = sixfoldVolume(at(n[0]), at(n[1]), at(n[2]), at(n[3])) / 6.0;
            report.volumeOfSolid[tet.entity.index] += volume;
            report.volume += volume;
        }
    }

    void checkSide(std::span<const SideRecord<3>> uses)
    {
        if (uses.size() > 2) {
            ++report.overSharedSides;
            return;
        }
        const MeshElement<4>& tet = mesh.tets[uses[0].owner];
        const bool hasTriangle = containsKey(triangles, uses[0].key);
        if (uses.size() == 1) {
            boundary.push_back(sideOf(tet, uses[0].side));
            if (!hasTriangle) ++report.boundaryWithoutElement;
            return;
        }
        const MeshElement<4>& other = mesh.tets[uses[1].owner];
        const bool isSameSide = isSameTurn(sideOf(tet, uses[0].side), sideOf(other, uses[1].side)) ==
                                (sign[uses[0].owner] == sign[uses[1].owner]);
        if (isSameSide) ++report.foldedSides;
        if (tet.entity != other.entity && !hasTriangle) ++report.interfaceWithoutElement;
    }

    void checkTriangles(const std::vector<SideRecord<3>>& sides)
    {
        for (const SideRecord<3>& record : triangles) {
            const auto found =
                std::lower_bound(sides.begin(), sides.end(), record.key,
                                 [](const SideRecord<3>& s, const auto& key) { return s.key < key; });
            if (found == sides.end() || found->key != record.key) {
                ++report.trianglesNotFaces;
                continue;
            }
            const bool isOuter = found + 1 == sides.end() || (found + 1)->key != record.key;
            const std::array<NodeId, 3> outward = sideOf(mesh.tets[found->owner], found->side);
            if (isOuter && !isSameTurn(mesh.triangles[record.owner].node, outward)) ++report.inwardTriangles;
        }
    }

    void checkBoundary()
    {
        std::vector<SideRecord<2>> edges;
        const Vec3 origin = at(mesh.tets.front().node[0]);
        double enclosed = 0.0;
        for (std::uint32_t i = 0; i < boundary.size(); ++i) {
            const auto& node = boundary[i];
            enclosed += sixfoldVolume(origin, at(node[0]), at(node[1]), at(node[2])) / 6.0;
            for (std::uint8_t k = 0; k < 3; ++k) {
                edges.push_back({sortedKey<2>({node[k], node[(k + 1u) % 3u]}), i, k});
            }
        }
        std::sort(edges.begin(), edges.end());
        forRuns<2>(edges, [&](std::size_t first, std::size_t last) {
            if ((last - first) % 2 != 0) ++report.openBoundaryEdges;
        });
        report.volumeGap = std::abs(enclosed - report.volume) / std::abs(report.volume);
    }
};

}  // namespace

void checkVolume(const ClassifiedMesh& mesh, MeshCheckReport& report)
{
    if (mesh.tets.empty()) return;
    VolumeCheck check{mesh, report, sortedRecords(mesh.triangles), {}, {}};
    check.measure();
    std::vector<SideRecord<3>> sides;
    sides.reserve(4 * mesh.tets.size());
    for (std::uint32_t i = 0; i < mesh.tets.size(); ++i) {
        for (std::uint8_t k = 0; k < 4; ++k) sides.push_back({sortedKey(sideOf(mesh.tets[i], k)), i, k});
    }
    std::sort(sides.begin(), sides.end());
    forRuns<3>(sides, [&](std::size_t first, std::size_t last) {
        check.checkSide({sides.data() + first, last - first});
    });
    check.checkTriangles(sides);
    check.checkBoundary();
}

}  // namespace mesher::detail
