#include "io/entity_groups.h"
#include "io/format_writers.h"
#include "io/gmsh_entities.h"
#include "io/gmsh_names.h"

namespace mesher {

namespace {

void writePoint(const Vec3& p, FileBuffer& out) { out << p.x << ' ' << p.y << ' ' << p.z; }

void writeEntity(std::size_t dimension, std::uint32_t tag, const GmshEntity& entity, FileBuffer& out)
{
    out << tag << ' ';
    writePoint(entity.box.low, out);
    if (dimension > 0) {
        out << ' ';
        writePoint(entity.box.high, out);
    }
    if (entity.isNamed) {
        out << " 1 " << tag;
    } else {
        out << " 0";
    }
    if (dimension > 0) {
        out << ' ' << entity.boundary.size();
        for (const std::int64_t side : entity.boundary) out << ' ' << side;
    }
    out << '\n';
}

void writeEntities(const GmshEntities& entities, FileBuffer& out)
{
    out << "$Entities\n";
    for (std::size_t d = 0; d < 4; ++d) out << entities.ofDimension(d).size() << (d < 3 ? ' ' : '\n');
    for (std::size_t d = 0; d < 4; ++d) {
        for (const auto& [tag, entity] : entities.ofDimension(d)) writeEntity(d, tag, entity, out);
    }
    out << "$EndEntities\n";
}

void writeNodes(const ClassifiedMesh& mesh, const GmshEntities& entities, FileBuffer& out)
{
    const EntityGroups grouped(mesh.nodes.size(),
                               [&](std::uint32_t i) { return entities.placeOf(mesh.nodes[NodeId(i)]); });
    const std::size_t count = mesh.nodes.size();
    out << "$Nodes\n"
        << grouped.groups.size() << ' ' << count << ' ' << (count > 0 ? 1 : 0) << ' ' << count << '\n';
    for (const EntityGroup& group : grouped.groups) {
        out << group.entity.dimension << ' ' << entities.tagOf(group.entity) << " 0 " << group.size() << '\n';
        for (std::uint32_t i = group.first; i < group.last; ++i) out << grouped.order[i] + 1 << '\n';
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            writePoint(mesh.nodes[NodeId(grouped.order[i])].position, out);
            out << '\n';
        }
    }
    out << "$EndNodes\n";
}

template <std::size_t N>
void writeBlocks(const std::vector<MeshElement<N>>& elements, const EntityGroups& grouped,
                 const GmshEntities& entities, std::size_t& nextTag, FileBuffer& out)
{
    for (const EntityGroup& group : grouped.groups) {
        out << N - 1 << ' ' << entities.tagOf(group.entity) << ' ' << kGmshElementType[N - 1] << ' '
            << group.size() << '\n';
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            out << nextTag++;
            for (const NodeId node : elements[grouped.order[i]].node) out << ' ' << node.value + 1;
            out << '\n';
        }
    }
}

void writeElements(const ClassifiedMesh& mesh, const GmshEntities& entities, FileBuffer& out)
{
    const EntityGroups points = groupByEntity(mesh.points);
    const EntityGroups lines = groupByEntity(mesh.lines);
    const EntityGroups triangles = groupByEntity(mesh.triangles);
    const EntityGroups tets = groupByEntity(mesh.tets);
    const std::size_t blocks =
        points.groups.size() + lines.groups.size() + triangles.groups.size() + tets.groups.size();
    const std::size_t count =
        mesh.points.size() + mesh.lines.size() + mesh.triangles.size() + mesh.tets.size();
    out << "$Elements\n" << blocks << ' ' << count << ' ' << (count > 0 ? 1 : 0) << ' ' << count << '\n';
    std::size_t nextTag = 1;
    writeBlocks(mesh.points, points, entities, nextTag, out);
    writeBlocks(mesh.lines, lines, entities, nextTag, out);
    writeBlocks(mesh.triangles, triangles, entities, nextTag, out);
    writeBlocks(mesh.tets, tets, entities, nextTag, out);
    out << "$EndElements\n";
}

}  // namespace

Result<void> writeGmsh41(const ClassifiedMesh& mesh, FileBuffer& out)
{
    const GmshEntities entities(mesh);
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    writePhysicalNames(entities, out);
    writeEntities(entities, out);
    writeNodes(mesh, entities, out);
    writeElements(mesh, entities, out);
    return {};
}

}  // namespace mesher
