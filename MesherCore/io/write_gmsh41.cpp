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
    if (entity.group != 0) {
        out << " 1 " << entity.group;
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

/// A mesh in the format: blocks of nodes and elements by entity. Nodes are numbered in the order of their blocks, since some
/// readers take the first node of the file for number 1.
class Gmsh41Writer
{
public:
    Gmsh41Writer(const ClassifiedMesh& mesh, GroupChoice groups, FileBuffer& out)
        : mesh_(mesh),
          entities_(mesh, groups),
          nodes_(mesh.nodes.size(),
                 [this](std::uint32_t i) { return entities_.placeOf(mesh_.nodes[NodeId(i)]); }),
          tagOf_(mesh.nodes.size()),
          out_(out)
    {
        for (std::uint32_t i = 0; i < nodes_.order.size(); ++i) tagOf_[NodeId(nodes_.order[i])] = i + 1;
    }

    void write()
    {
        out_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
        writePhysicalNames(entities_, out_);
        writeEntities(entities_, out_);
        writeNodes();
        const Blocks blocks = {blocksOf(mesh_.points), blocksOf(mesh_.lines), blocksOf(mesh_.triangles),
                               blocksOf(mesh_.tets)};
        std::size_t blockCount = 0, count = 0;
        for (const EntityGroups& grouped : blocks) {
            blockCount += grouped.groups.size();
            count += grouped.order.size();
        }
        out_ << "$Elements\n"
             << blockCount << ' ' << count << ' ' << (count > 0 ? 1 : 0) << ' ' << count << '\n';
        writeBlocks(mesh_.points, blocks[0]);
        writeBlocks(mesh_.lines, blocks[1]);
        writeBlocks(mesh_.triangles, blocks[2]);
        writeBlocks(mesh_.tets, blocks[3]);
        out_ << "$EndElements\n";
    }

private:
    using Blocks = std::array<EntityGroups, 4>;

    void writeNodes()
    {
        const std::size_t count = mesh_.nodes.size();
        out_ << "$Nodes\n"
             << nodes_.groups.size() << ' ' << count << ' ' << (count > 0 ? 1 : 0) << ' ' << count << '\n';
        for (const EntityGroup& group : nodes_.groups) {
            out_ << group.entity.dimension << ' ' << entities_.tagOf(group.entity) << " 0 " << group.size()
                 << '\n';
            for (std::uint32_t i = group.first; i < group.last; ++i) out_ << i + 1 << '\n';
            for (std::uint32_t i = group.first; i < group.last; ++i) {
                writePoint(mesh_.nodes[NodeId(nodes_.order[i])].position, out_);
                out_ << '\n';
            }
        }
        out_ << "$EndNodes\n";
    }

    template <std::size_t N>
    [[nodiscard]] EntityGroups blocksOf(const std::vector<MeshElement<N>>& elements) const
    {
        return entities_.hasElements(N - 1) ? groupByEntity(elements)
                                            : groupByEntity(std::vector<MeshElement<N>>());
    }

    template <std::size_t N>
    void writeBlocks(const std::vector<MeshElement<N>>& elements, const EntityGroups& grouped)
    {
        for (const EntityGroup& group : grouped.groups) {
            out_ << N - 1 << ' ' << entities_.tagOf(group.entity) << ' ' << kGmshElementType[N - 1] << ' '
                 << group.size() << '\n';
            for (std::uint32_t i = group.first; i < group.last; ++i) {
                out_ << nextElement_++;
                for (const NodeId node : elements[grouped.order[i]].node) out_ << ' ' << tagOf_[node];
                out_ << '\n';
            }
        }
    }

    const ClassifiedMesh& mesh_;
    GmshEntities entities_;
    EntityGroups nodes_;
    IdVector<NodeId, std::uint32_t> tagOf_;
    FileBuffer& out_;
    std::size_t nextElement_ = 1;
};

}  // namespace

Result<void> writeGmsh41(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options)
{
    Gmsh41Writer(mesh, options.groups, out).write();
    return {};
}

}  // namespace mesher
