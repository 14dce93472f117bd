#include "delaunay/mesh_hash.h"

#include "delaunay/triangulation3d.h"

namespace mesher {

namespace {

constexpr std::uint64_t kTetKind = 3;
constexpr std::uint64_t kConstrainedFaceKind = 32;
constexpr std::uint64_t kConstrainedEdgeKind = 31;

/// Hash of the constraints of one tetrahedron, each counted where the tetrahedron is the first that has it.
std::uint64_t constraintHash(const Triangulation3d& mesh, TetId tet,
                             const std::array<std::uint64_t, 4>& place)
{
    std::uint64_t sum = 0;
    for (int face = 0; face < 4; ++face) {
        if (!mesh.isFaceConstrained({tet, face}) || mesh.neighbour(tet, face).tet() < tet) continue;
        const auto& s = kFaceSlots[face];
        sum += simplexHash<3>({place[static_cast<unsigned>(s[0])], place[static_cast<unsigned>(s[1])],
                               place[static_cast<unsigned>(s[2])]},
                              kConstrainedFaceKind);
    }
    std::vector<TetId> ring;
    for (int edge = 0; edge < 6; ++edge) {
        if (!mesh.isEdgeConstrained(tet, edge)) continue;
        const auto& s = kEdgeSlots[edge];
        mesh.collectEdgeRing(tet, mesh.vertex(tet, s[0]), mesh.vertex(tet, s[1]), ring);
        if (*std::min_element(ring.begin(), ring.end()) != tet) continue;
        sum += simplexHash<2>({place[static_cast<unsigned>(s[0])], place[static_cast<unsigned>(s[1])]},
                              kConstrainedEdgeKind);
    }
    return sum;
}

}  // namespace

std::uint64_t meshHash3d(const Triangulation3d& mesh)
{
    std::uint64_t sum = 0;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet)) continue;
        std::array<std::uint64_t, 4> place{};
        for (unsigned slot = 0; slot < 4; ++slot) {
            const VertexId v = mesh.tet(tet).vertex[slot];
            if (!isGhost(v)) place[slot] = placeHash(mesh.position(v));
        }
        if (!mesh.isGhostTet(tet)) sum += simplexHash<4>(place, kTetKind);
        if ((mesh.flags(tet) & tet_flag::kConstraints) != 0) sum += constraintHash(mesh, tet, place);
    }
    return mixBits(sum);
}

}  // namespace mesher
