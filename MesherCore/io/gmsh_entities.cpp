#include "io/gmsh_entities.h"

#include "io/element_sides.h"

#include <algorithm>

namespace mesher {

namespace {

void insertOnce(std::vector<std::int64_t>& tags, std::int64_t tag)
{
    if (!tags.empty() && tags.back() == tag) return;
    if (std::find(tags.begin(), tags.end(), tag) == tags.end()) tags.push_back(tag);
}

template <std::size_t N>
EntityRef ownEntity(const MeshElement<N>& element)
{
    constexpr auto kDimension = static_cast<std::uint8_t>(N - 1);
    return element.entity.dimension == kDimension ? element.entity : EntityRef{kDimension, EntityRef::kNone};
}

}  // namespace

GmshEntities::GmshEntities(const ClassifiedMesh& mesh, GroupChoice groups)
    : numbers_(mesh, groups), meshDimension_(dimensionOf(mesh))
{
    for (const MeshNode& node : mesh.nodes) {
        at(placeOf(node)).box.include(node.position);
    }
    include(mesh, mesh.points);
    include(mesh, mesh.lines);
    include(mesh, mesh.triangles);
    include(mesh, mesh.tets);
    connectCurves(mesh);
    connectSurfaces(mesh);
    connectVolumes(mesh);
}

GmshEntity& GmshEntities::at(EntityRef entity)
{
    GmshEntity& found = entities_[entity.dimension][tagOf(entity)];
    found.entity = entity;
    found.group = numbers_.numberOf(entity);
    return found;
}

EntityRef GmshEntities::placeOf(const MeshNode& node) const
{
    return node.entity.index == EntityRef::kNone ? EntityRef{meshDimension_, EntityRef::kNone} : node.entity;
}

template <std::size_t N>
void GmshEntities::include(const ClassifiedMesh& mesh, const std::vector<MeshElement<N>>& elements)
{
    const EntityGroups grouped = groupByEntity(elements);
    for (const EntityGroup& group : grouped.groups) {
        GmshEntity& entity = at(group.entity);
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            for (const NodeId node : elements[grouped.order[i]].node)
                entity.box.include(mesh.nodes[node].position);
        }
    }
}

/// Lines run along the parameter of their edge, so a start is the first node of a line, an end the last one of another.
void GmshEntities::connectCurves(const ClassifiedMesh& mesh)
{
    for (const int end : {0, 1}) {
        for (const MeshElement<2>& line : mesh.lines) {
            const EntityRef entity = mesh.nodes[line.node[static_cast<std::size_t>(end)]].entity;
            if (entity.dimension != 0 || entity.index == EntityRef::kNone) continue;
            const auto tag = static_cast<std::int64_t>(tagOf(entity));
            insertOnce(entities_[1][tagOf(ownEntity(line))].boundary, end == 0 ? tag : -tag);
        }
    }
}

void GmshEntities::connectSurfaces(const ClassifiedMesh& mesh)
{
    const ElementSides sides = ElementSides::ofLines(mesh);
    for (std::uint32_t i = 0; i < mesh.lines.size(); ++i) {
        const auto tag = static_cast<std::int64_t>(tagOf(ownEntity(mesh.lines[i])));
        for (const ElementSide& side : sides.of(i)) {
            insertOnce(entities_[2][tagOf(ownEntity(mesh.triangles[side.element]))].boundary, tag);
        }
    }
}

void GmshEntities::connectVolumes(const ClassifiedMesh& mesh)
{
    const ElementSides sides = ElementSides::ofTriangles(mesh);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto tag = static_cast<std::int64_t>(tagOf(ownEntity(mesh.triangles[i])));
        for (const ElementSide& side : sides.of(i)) {
            insertOnce(entities_[3][tagOf(ownEntity(mesh.tets[side.element]))].boundary, tag);
        }
    }
}

}  // namespace mesher
