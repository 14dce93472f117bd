#include "delaunay/locate3d.h"

#include "predicates/orient3d.h"

namespace mesher {

TetId walk3d(const Triangulation3d& mesh, const Vec3& point, TetId hint, const StaticFilter3d& filter,
             Random& random)
{
    const VertexRecord* vertices = mesh.vertexData();
    const TetRecord* tets = mesh.tetData();
    TetId current = mesh.isGhostTet(hint) ? mesh.neighbour(hint, 3).tet() : hint;
    unsigned entered = 4;
    std::uint64_t bits = random();
    for (unsigned step = 1;; ++step) {
        const TetRecord& record = tets[current.value];
        // Drawn anew when used up: choices that repeat could go round in circles where it is not Delaunay.
        bits = step % 32 == 0 ? random() : bits >> 2;
        const unsigned first = static_cast<unsigned>(bits & 3u);
        TetFace next;
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned face = (first + i) & 3u;
            if (face == entered) continue;
            const int* slots = kFaceSlots[face];
            const Sign side =
                orient3d(filter, vertices[record.vertex[static_cast<unsigned>(slots[0])].value].position,
                         vertices[record.vertex[static_cast<unsigned>(slots[1])].value].position,
                         vertices[record.vertex[static_cast<unsigned>(slots[2])].value].position, point);
            if (side == Sign::Negative) {
                next = record.neighbour[face];
                break;
            }
        }
        if (!next.isValid()) return current;
        current = next.tet();
        entered = static_cast<unsigned>(next.face());
        if (isGhost(tets[current.value].vertex[3])) return current;
    }
}

Location3d classifyLocation3d(const Triangulation3d& mesh, const Vec3& point, TetId found,
                              const StaticFilter3d& filter)
{
    if (mesh.isGhostTet(found)) return {Location3d::Kind::Outside, found, -1};
    int zeros[4];
    int zeroCount = 0;
    for (int face = 0; face < 4; ++face) {
        const auto [f0, f1, f2] = mesh.faceVertices({found, face});
        const Sign side = orient3d(filter, mesh.position(f0), mesh.position(f1), mesh.position(f2), point);
        MESHER_INVARIANT(side != Sign::Negative);
        if (side == Sign::Zero) zeros[zeroCount++] = face;
    }
    if (zeroCount == 0) return {Location3d::Kind::Tet, found, -1};
    if (zeroCount == 1) return {Location3d::Kind::Face, found, zeros[0]};
    if (zeroCount == 2) {
        // The edge of two faces joins the two vertices that neither face is opposite to.
        const int opposite = kEdgeOfSlots[zeros[0]][zeros[1]];
        return {Location3d::Kind::Edge, found, 5 - opposite};
    }
    return {Location3d::Kind::Vertex, found, 6 - zeros[0] - zeros[1] - zeros[2]};
}

}  // namespace mesher
