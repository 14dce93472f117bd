#include "io/entity_groups.h"
#include "io/format_writers.h"
#include "io/outer_triangles.h"
#include "quality/quality_statistics.h"

#include <array>
#include <bit>
#include <limits>

namespace mesher {

namespace {

Vec3 unitNormal(const TriangleCorners& corners)
{
    const Vec3 vector = doubleAreaVector(corners);
    const double size = length(vector);
    return size > 0.0 ? (1.0 / size) * vector : Vec3{};
}

Result<void> refuseWithoutTriangles(const std::vector<std::uint32_t>& triangles)
{
    if (!triangles.empty()) return {};
    return Error{ErrorCode::InvalidArgument, "the mesh has no triangles to write as STL", {}, {}, {}};
}

template <class T>
void appendLittleEndian(T value, FileBuffer& out)
{
    static_assert(std::endian::native == std::endian::little);
    out.append(std::bit_cast<std::array<char, sizeof(T)>>(value));
}

void appendSingle(const Vec3& p, FileBuffer& out)
{
    appendLittleEndian(static_cast<float>(p.x), out);
    appendLittleEndian(static_cast<float>(p.y), out);
    appendLittleEndian(static_cast<float>(p.z), out);
}

}  // namespace

Result<void> writeStlText(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    const std::vector<std::uint32_t> triangles = outerTriangles(mesh);
    if (const Result<void> possible = refuseWithoutTriangles(triangles); !possible) return possible;
    const EntityGroups grouped(triangles.size(),
                               [&](std::uint32_t i) { return mesh.triangles[triangles[i]].entity; });
    for (const EntityGroup& group : grouped.groups) {
        const std::string name = group.isNamed() ? nameOf(group.entity) : "unnamed";
        out << "solid " << name << '\n';
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            const TriangleCorners corners = cornersOf(mesh, mesh.triangles[triangles[grouped.order[i]]]);
            const Vec3 normal = unitNormal(corners);
            out << "facet normal " << normal.x << ' ' << normal.y << ' ' << normal.z << "\nouter loop\n";
            for (const Vec3& p : corners) out << "vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
            out << "endloop\nendfacet\n";
        }
        out << "endsolid " << name << '\n';
    }
    return {};
}

Result<void> writeStlBinary(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    const std::vector<std::uint32_t> triangles = outerTriangles(mesh);
    if (const Result<void> possible = refuseWithoutTriangles(triangles); !possible) return possible;
    std::string header = "binary STL, unit " + mesh.unit.substr(0, 20);  // must not begin with "solid"
    header.resize(80, ' ');
    out << header;
    appendLittleEndian(static_cast<std::uint32_t>(triangles.size()), out);
    for (const std::uint32_t i : triangles) {
        const MeshElement<3>& triangle = mesh.triangles[i];
        const TriangleCorners corners = cornersOf(mesh, triangle);
        appendSingle(unitNormal(corners), out);
        for (const Vec3& p : corners) appendSingle(p, out);
        const std::uint32_t face = triangle.entity.index + 1;  // the attribute of 16 bits; 0 without a face
        appendLittleEndian(
            static_cast<std::uint16_t>(face <= std::numeric_limits<std::uint16_t>::max() ? face : 0), out);
    }
    return {};
}

}  // namespace mesher
