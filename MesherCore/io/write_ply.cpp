#include "io/format_writers.h"
#include "io/outer_triangles.h"

namespace mesher {

namespace {

constexpr std::uint32_t kUnused = 0xFFFFFFFFu;

/// Numbers from 0 of the nodes that the triangles have.
IdVector<NodeId, std::uint32_t> numberNodes(const ClassifiedMesh& mesh,
                                            const std::vector<std::uint32_t>& triangles, std::uint32_t& count)
{
    IdVector<NodeId, std::uint32_t> number(mesh.nodes.size(), kUnused);
    for (const std::uint32_t i : triangles) {
        for (const NodeId node : mesh.triangles[i].node) number[node] = 0;
    }
    count = 0;
    for (std::uint32_t& n : number) {
        if (n != kUnused) n = count++;
    }
    return number;
}

}  // namespace

/// As text, since that is all that some readers take.
Result<void> writePly(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    const std::vector<std::uint32_t> triangles = outerTriangles(mesh);
    if (triangles.empty()) {
        return Error{ErrorCode::InvalidArgument, "the mesh has no triangles to write as PLY", {}, {}, {}};
    }
    std::uint32_t count = 0;
    const IdVector<NodeId, std::uint32_t> number = numberNodes(mesh, triangles, count);
    out << "ply\nformat ascii 1.0\ncomment unit " << mesh.unit << "\nelement vertex " << count
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << triangles.size()
        << "\nproperty list uchar int vertex_indices\nproperty int face\nend_header\n";
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        if (number[NodeId(i)] == kUnused) continue;
        const Vec3& p = mesh.nodes[NodeId(i)].position;
        out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    for (const std::uint32_t i : triangles) {
        out << '3';
        for (const NodeId node : mesh.triangles[i].node) out << ' ' << number[node];
        out << ' ' << mesh.triangles[i].entity.index + 1 << '\n';  // 0 without a face
    }
    return {};
}

}  // namespace mesher
