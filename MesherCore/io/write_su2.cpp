#include "io/element_sides.h"
#include "io/entity_groups.h"
#include "io/format_writers.h"

#include <algorithm>

namespace mesher {

namespace {

constexpr std::array<int, 5> kVtkType = {0, 1, 3, 5, 10};  // by number of nodes

/// SU2 numbers from 0 and wants no node that is in no element.
IdVector<NodeId, std::uint32_t> numberNodes(const ClassifiedMesh& mesh, bool isVolume,
                                            std::vector<NodeId>& used)
{
    constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
    IdVector<NodeId, std::uint32_t> number(mesh.nodes.size(), kUnused);
    const auto mark = [&](const auto& elements) {
        for (const auto& element : elements) {
            for (const NodeId node : element.node) number[node] = 0;
        }
    };
    if (isVolume) {
        mark(mesh.tets);
    } else {
        mark(mesh.triangles);
    }
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        if (number[NodeId(i)] == kUnused) continue;
        number[NodeId(i)] = static_cast<std::uint32_t>(used.size());
        used.push_back(NodeId(i));
    }
    return number;
}

template <std::size_t N>
void writeElement(const MeshElement<N>& element, const IdVector<NodeId, std::uint32_t>& number,
                  FileBuffer& out)
{
    out << kVtkType[N];
    for (const NodeId node : element.node) out << ' ' << number[node];
}

template <std::size_t N>
void writeElements(const std::vector<MeshElement<N>>& elements, const IdVector<NodeId, std::uint32_t>& number,
                   FileBuffer& out)
{
    out << "NELEM= " << elements.size() << '\n';
    for (std::size_t i = 0; i < elements.size(); ++i) {
        writeElement(elements[i], number, out);
        out << ' ' << i << '\n';
    }
}

/// Only what has an element on one side bounds the flow; what lies inside is no boundary to SU2.
template <std::size_t N>
void writeMarkers(const std::vector<MeshElement<N>>& elements, const ElementSides& sides,
                  const IdVector<NodeId, std::uint32_t>& number, FileBuffer& out)
{
    const EntityGroups grouped = groupByEntity(elements);
    std::vector<std::pair<std::string, std::vector<std::uint32_t>>> markers;
    for (const EntityGroup& group : grouped.groups) {
        std::vector<std::uint32_t> outer;
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            if (sides.of(grouped.order[i]).size() == 1) outer.push_back(grouped.order[i]);
        }
        if (!outer.empty())
            markers.emplace_back(group.isNamed() ? nameOf(group.entity) : "unnamed", std::move(outer));
    }
    out << "NMARK= " << markers.size() << '\n';
    for (const auto& [name, members] : markers) {
        out << "MARKER_TAG= " << name << "\nMARKER_ELEMS= " << members.size() << '\n';
        for (const std::uint32_t i : members) {
            writeElement(elements[i], number, out);
            out << '\n';
        }
    }
}

bool isLevel(const ClassifiedMesh& mesh, const std::vector<NodeId>& nodes)
{
    return std::all_of(nodes.begin(), nodes.end(), [&](NodeId node) {
        return mesh.nodes[node].position.z == mesh.nodes[nodes.front()].position.z;
    });
}

}  // namespace

Result<void> writeSu2(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    const bool isVolume = !mesh.tets.empty();
    std::vector<NodeId> used;
    const IdVector<NodeId, std::uint32_t> number = numberNodes(mesh, isVolume, used);
    if (used.empty()) {
        return Error{ErrorCode::InvalidArgument,
                     "the mesh has no triangles and no tetrahedra to write as SU2",
                     {},
                     {},
                     {}};
    }
    if (!isVolume && !isLevel(mesh, used)) {
        return Error{ErrorCode::InvalidArgument,
                     "SU2 wants a plane mesh at constant z",
                     {},
                     {},
                     "turn the face into the plane z = 0 or mesh the solid"};
    }
    out << "NDIME= " << (isVolume ? 3 : 2) << '\n';
    if (isVolume) {
        writeElements(mesh.tets, number, out);
    } else {
        writeElements(mesh.triangles, number, out);
    }
    out << "NPOIN= " << used.size() << '\n';
    for (std::size_t i = 0; i < used.size(); ++i) {
        const Vec3& p = mesh.nodes[used[i]].position;
        out << p.x << ' ' << p.y << ' ';
        if (isVolume) out << p.z << ' ';
        out << i << '\n';
    }
    if (isVolume) {
        writeMarkers(mesh.triangles, ElementSides::ofTriangles(mesh), number, out);
    } else {
        writeMarkers(mesh.lines, ElementSides::ofLines(mesh), number, out);
    }
    return {};
}

}  // namespace mesher
