#include "io/entity_groups.h"
#include "io/format_writers.h"
#include "io/gmsh_entities.h"
#include "io/gmsh_names.h"

namespace mesher {

namespace {

template <std::size_t N>
void writeElements(const std::vector<MeshElement<N>>& elements, const GmshEntities& entities,
                   std::size_t& nextTag, FileBuffer& out)
{
    if (!entities.hasElements(N - 1)) return;
    const EntityGroups grouped = groupByEntity(elements);
    for (const EntityGroup& group : grouped.groups) {
        const std::uint32_t tag = entities.tagOf(group.entity);
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            out << nextTag++ << ' ' << kGmshElementType[N - 1] << " 2 " << entities.groupOf(group.entity)
                << ' ' << tag;
            for (const NodeId node : elements[grouped.order[i]].node) out << ' ' << node.value + 1;
            out << '\n';
        }
    }
}

std::size_t countElements(const ClassifiedMesh& mesh, const GmshEntities& entities)
{
    const std::array<std::size_t, 4> counts = {mesh.points.size(), mesh.lines.size(), mesh.triangles.size(),
                                               mesh.tets.size()};
    std::size_t count = 0;
    for (std::uint8_t d = 0; d < 4; ++d) count += entities.hasElements(d) ? counts[d] : 0;
    return count;
}

}  // namespace

Result<void> writeGmsh22(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options)
{
    const GmshEntities entities(mesh, options.groups);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    writePhysicalNames(entities, out);
    out << "$Nodes\n" << mesh.nodes.size() << '\n';
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3& p = mesh.nodes[NodeId(i)].position;
        out << i + 1 << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    out << "$EndNodes\n$Elements\n" << countElements(mesh, entities) << '\n';
    std::size_t nextTag = 1;
    writeElements(mesh.points, entities, nextTag, out);
    writeElements(mesh.lines, entities, nextTag, out);
    writeElements(mesh.triangles, entities, nextTag, out);
    writeElements(mesh.tets, entities, nextTag, out);
    out << "$EndElements\n";
    return {};
}

}  // namespace mesher
