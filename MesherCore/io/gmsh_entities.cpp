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

GmshEntities::GmshEntities(const ClassifiedMesh& mesh)
{
    meshDimension_ = !mesh.tets.empty() ? 3 : (!mesh.triangles.empty() ? 2 : (!mesh.lines.empty() ? 1 : 0));
    countEntities(mesh);
    for (const MeshNode& node : mesh.nodes) {
        const EntityRef place = placeOf(node);
        GmshEntity& entity = entities_[place.dimension][tagOf(place)];
        entity.box.include(node.position);
        entity.isNamed = place.index != EntityRef::kNone;
    }
    include(mesh, mesh.points);
    include(mesh, mesh.lines);
    include(mesh, mesh.triangles);
    include(mesh, mesh.tets);
    connectCurves(mesh);
    connectSurfaces(mesh);
    connectVolumes(mesh);
}

std::uint32_t GmshEntities::tagOf(EntityRef entity) const
{
    return entity.index == EntityRef::kNone ? entityCount_[entity.dimension] + 1 : entity.index + 1;
}

EntityRef GmshEntities::placeOf(const MeshNode& node) const
{
    return node.entity.index == EntityRef::kNone ? EntityRef{meshDimension_, EntityRef::kNone} : node.entity;
}

void GmshEntities::countEntities(const ClassifiedMesh& mesh)
{
    const auto count = [&](EntityRef entity) {
        if (entity.index == EntityRef::kNone) return;
        entityCount_[entity.dimension] = std::max(entityCount_[entity.dimension], entity.index + 1);
    };
    for (const MeshNode& node : mesh.nodes) count(node.entity);
    for (const auto& element : mesh.points) count(ownEntity(element));
    for (const auto& element : mesh.lines) count(ownEntity(element));
    for (const auto& element : mesh.triangles) count(ownEntity(element));
    for (const auto& element : mesh.tets) count(ownEntity(element));
}

template <std::size_t N>
void GmshEntities::include(const ClassifiedMesh& mesh, const std::vector<MeshElement<N>>& elements)
{
    const EntityGroups grouped = groupByEntity(elements);
    for (const EntityGroup& group : grouped.groups) {
        GmshEntity& entity = entities_[N - 1][tagOf(group.entity)];
        entity.isNamed = group.isNamed();
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
