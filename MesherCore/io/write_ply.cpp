#include "io/format_writers.h"

#include <array>
#include <bit>

namespace mesher {

namespace {

template <class T>
void appendLittleEndian(T value, FileBuffer& out)
{
    static_assert(std::endian::native == std::endian::little);
    out.append(std::bit_cast<std::array<char, sizeof(T)>>(value));
}

}  // namespace

Result<void> writePly(const ClassifiedMesh& mesh, FileBuffer& out)
{
    if (mesh.triangles.empty()) {
        return Error{ErrorCode::InvalidArgument, "the mesh has no triangles to write as PLY", {}, {}, {}};
    }
    constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
    IdVector<NodeId, std::uint32_t> number(mesh.nodes.size(), kUnused);
    for (const MeshElement<3>& triangle : mesh.triangles) {
        for (const NodeId node : triangle.node) number[node] = 0;
    }
    std::uint32_t count = 0;
    for (std::uint32_t& n : number) {
        if (n != kUnused) n = count++;
    }
    out << "ply\nformat binary_little_endian 1.0\ncomment unit " << mesh.unit << "\nelement vertex " << count
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.triangles.size()
        << "\nproperty list uchar int vertex_indices\nproperty int face\nend_header\n";
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        if (number[NodeId(i)] == kUnused) continue;
        const Vec3& p = mesh.nodes[NodeId(i)].position;
        appendLittleEndian(p.x, out);
        appendLittleEndian(p.y, out);
        appendLittleEndian(p.z, out);
    }
    for (const MeshElement<3>& triangle : mesh.triangles) {
        appendLittleEndian(std::uint8_t{3}, out);
        for (const NodeId node : triangle.node) appendLittleEndian(number[node], out);
        appendLittleEndian(triangle.entity.index + 1, out);  // 0 without a face
    }
    return {};
}

}  // namespace mesher
