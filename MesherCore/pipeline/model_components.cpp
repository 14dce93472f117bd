#include "pipeline/model_components.h"

#include "brep/model_welding.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace mesher {

namespace {

/// The entities of each dimension that belong to a component, by their ids in the whole.
struct Members
{
    std::vector<BrepVertexId> vertices;
    std::vector<BrepEdgeId> edges;
    std::vector<BrepFaceId> faces;
    std::vector<BrepSolidId> solids;
};

template <class T>
void makeUnique(std::vector<T>& ids)
{
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

Members membersOf(const BrepModel& model, std::vector<BrepFaceId> faces)
{
    Members members;
    members.faces = std::move(faces);
    makeUnique(members.faces);
    for (const BrepFaceId f : members.faces) {
        const BrepFace& face = model.faces[f];
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) members.edges.push_back(coedge.edge);
        }
        members.edges.insert(members.edges.end(), face.embeddedEdges.begin(), face.embeddedEdges.end());
        members.vertices.insert(members.vertices.end(), face.embeddedVertices.begin(),
                                face.embeddedVertices.end());
    }
    makeUnique(members.edges);
    for (const BrepEdgeId e : members.edges) {
        members.vertices.push_back(model.edges[e].first);
        members.vertices.push_back(model.edges[e].last);
    }
    makeUnique(members.vertices);
    return members;
}

Members membersOf(const BrepModel& model, std::vector<BrepSolidId> solids)
{
    std::vector<BrepFaceId> faces;
    for (const BrepSolidId s : solids) {
        for (const BrepShell& shell : model.solids[s].shells) {
            for (const BrepShellFace& face : shell.faces) faces.push_back(face.face);
        }
    }
    Members members = membersOf(model, std::move(faces));
    members.solids = std::move(solids);
    return members;
}

class SolidGroups
{
public:
    explicit SolidGroups(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t rootOf(std::uint32_t i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// The smaller root stays, so that groups are in the order of their first solids.
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = rootOf(a);
        b = rootOf(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

std::vector<std::vector<BrepSolidId>> groupsOf(const BrepModel& model)
{
    const auto count = static_cast<std::uint32_t>(model.solids.size());
    SolidGroups groups(count);
    IdVector<BrepVertexId, BrepSolidId> solidAt(model.vertices.size());
    IdVector<BrepFaceId, BrepSolidId> solidBeside(model.faces.size());
    for (std::uint32_t s = 0; s < count; ++s) {
        const Members members = membersOf(model, std::vector{BrepSolidId(s)});
        for (const BrepVertexId v : members.vertices) {
            if (solidAt[v].isValid()) groups.join(solidAt[v].value, s);
            solidAt[v] = BrepSolidId(s);
        }
        // A face without edges has no vertex that would tell.
        for (const BrepFaceId f : members.faces) {
            if (solidBeside[f].isValid()) groups.join(solidBeside[f].value, s);
            solidBeside[f] = BrepSolidId(s);
        }
    }
    std::vector<std::vector<BrepSolidId>> byRoot(count);
    for (std::uint32_t s = 0; s < count; ++s) byRoot[groups.rootOf(s)].push_back(BrepSolidId(s));
    std::erase_if(byRoot, [](const auto& group) { return group.empty(); });
    return byRoot;
}

/// The new ids of the entities of one kind.
template <class EntityId>
IdVector<EntityId, EntityId> numbered(const std::vector<EntityId>& kept, std::size_t count)
{
    IdVector<EntityId, EntityId> numbers(count);
    for (std::uint32_t i = 0; i < kept.size(); ++i) numbers[kept[i]] = EntityId(i);
    return numbers;
}

template <class EntityId>
IdVector<EntityId, EntityId> asIdVector(const std::vector<EntityId>& ids)
{
    IdVector<EntityId, EntityId> result;
    for (const EntityId id : ids) result.push_back(id);
    return result;
}

ModelComponent extract(const BrepModel& model, const Members& members)
{
    const auto vertexAt = numbered(members.vertices, model.vertices.size());
    const auto edgeAt = numbered(members.edges, model.edges.size());
    const auto faceAt = numbered(members.faces, model.faces.size());
    ModelComponent part;
    part.vertexOf = asIdVector(members.vertices);
    part.edgeOf = asIdVector(members.edges);
    part.faceOf = asIdVector(members.faces);
    part.solidOf = asIdVector(members.solids);
    part.model.unit = model.unit;
    part.model.box = model.box;
    for (const BrepVertexId v : members.vertices) part.model.vertices.push_back(model.vertices[v]);
    for (const BrepEdgeId e : members.edges) {
        BrepEdge edge = model.edges[e];
        edge.first = vertexAt[edge.first];
        edge.last = vertexAt[edge.last];
        part.model.edges.push_back(std::move(edge));
    }
    for (const BrepFaceId f : members.faces) {
        BrepFace face = model.faces[f];
        for (BrepLoop& loop : face.loops) {
            for (BrepCoedge& coedge : loop.coedges) coedge.edge = edgeAt[coedge.edge];
        }
        for (BrepVertexId& v : face.embeddedVertices) v = vertexAt[v];
        for (BrepEdgeId& e : face.embeddedEdges) e = edgeAt[e];
        part.model.faces.push_back(std::move(face));
    }
    for (const BrepSolidId s : members.solids) {
        BrepSolid solid = model.solids[s];
        for (BrepShell& shell : solid.shells) {
            for (BrepShellFace& face : shell.faces) face.face = faceAt[face.face];
        }
        part.model.solids.push_back(std::move(solid));
    }
    return part;
}

template <class EntityId>
void compose(const IdVector<EntityId, EntityId>& outer, IdVector<EntityId, EntityId>& inner)
{
    for (EntityId& id : inner) id = outer[id];
}

template <class EntityId>
void noteTwins(const IdVector<EntityId, EntityId>& keptOf, const IdVector<EntityId, EntityId>& inWhole,
               std::vector<std::string>& notes)
{
    for (std::uint32_t i = 0; i < keptOf.size(); ++i) {
        const EntityId twin(i), kept = keptOf[twin];
        if (kept != twin)
            notes.push_back(nameOf(inWhole[twin]) + " is where " + nameOf(inWhole[kept]) +
                            " is, which has the elements of both");
    }
}

/// The component without the vertices and edges that others stand for.
ModelComponent weld(ModelComponent part)
{
    const WeldedEntities welded = weldCoincidences(part.model);
    if (welded.vertices == 0 && welded.edges == 0) return part;
    std::vector<BrepSolidId> solids;
    for (std::uint32_t s = 0; s < part.model.solids.size(); ++s) solids.emplace_back(s);
    const Members members = membersOf(part.model, std::move(solids));
    ModelComponent result = extract(part.model, members);
    noteTwins(welded.vertex, part.vertexOf, result.notes);
    noteTwins(welded.edge, part.edgeOf, result.notes);
    compose(part.vertexOf, result.vertexOf);
    compose(part.edgeOf, result.edgeOf);
    compose(part.faceOf, result.faceOf);
    compose(part.solidOf, result.solidOf);
    return result;
}

}  // namespace

EntityRef ModelComponent::inWhole(EntityRef entity) const
{
    if (entity.index == EntityRef::kNone) return entity;
    switch (entity.dimension) {
        case 0: entity.index = vertexOf[BrepVertexId(entity.index)].value; break;
        case 1: entity.index = edgeOf[BrepEdgeId(entity.index)].value; break;
        case 2: entity.index = faceOf[BrepFaceId(entity.index)].value; break;
        default: entity.index = solidOf[BrepSolidId(entity.index)].value; break;
    }
    return entity;
}

std::string ModelComponent::inWhole(const std::string& text) const
{
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])) != 0) ++end;
        const std::string word = text.substr(i, std::max(end, i + 1) - i);
        const std::optional<EntityRef> entity = entityNamed(word);
        result += entity ? nameOf(inWhole(*entity)) : word;
        i += word.size();
    }
    return result;
}

std::vector<ModelComponent> solidComponents(const BrepModel& model)
{
    std::vector<ModelComponent> components;
    for (std::vector<BrepSolidId>& group : groupsOf(model))
        components.push_back(weld(extract(model, membersOf(model, std::move(group)))));
    return components;
}

ModelComponent solidAlone(const BrepModel& model, BrepSolidId solid)
{
    return weld(extract(model, membersOf(model, std::vector{solid})));
}

ModelComponent facesAlone(const BrepModel& model, std::vector<BrepFaceId> faces)
{
    return extract(model, membersOf(model, std::move(faces)));
}

void appendComponent(const ModelComponent& component, const ClassifiedMesh& part, ClassifiedMesh& whole)
{
    const auto shift = static_cast<std::uint32_t>(whole.nodes.size());
    for (MeshNode node : part.nodes) {
        node.entity = component.inWhole(node.entity);
        whole.nodes.push_back(node);
    }
    const auto append = [&](const auto& elements, auto& target) {
        for (auto element : elements) {
            for (NodeId& node : element.node) node = NodeId(node.value + shift);
            element.entity = component.inWhole(element.entity);
            target.push_back(element);
        }
    };
    append(part.points, whole.points);
    append(part.lines, whole.lines);
    append(part.triangles, whole.triangles);
    append(part.tets, whole.tets);
}

}  // namespace mesher
