#include "io/element_sides.h"
#include "io/entity_groups.h"
#include "io/format_writers.h"
#include "io/short_number.h"

#include <algorithm>

namespace mesher {

namespace {

/// CalculiX reads this much of a number and leaves out the rest, be it an exponent.
constexpr std::size_t kLongestNumber = 20;

/// The solver's number of the side opposite to each corner of a C3D4.
constexpr std::array<int, 4> kTetSideLabel = {3, 4, 2, 1};

/// Sets are lists of at most 16 numbers a line.
class NumberList
{
public:
    explicit NumberList(FileBuffer& out) : out_(out) {}

    void add(std::size_t number) { out_ << number << (++count_ % kPerLine == 0 ? ",\n" : ", "); }
    void finish()
    {
        if (count_ % kPerLine != 0) out_ << '\n';
    }

private:
    static constexpr std::size_t kPerLine = 16;
    FileBuffer& out_;
    std::size_t count_ = 0;
};

template <std::size_t N>
void writeElements(const std::vector<MeshElement<N>>& elements, std::string_view type, FileBuffer& out)
{
    const EntityGroups grouped = groupByEntity(elements);
    for (const EntityGroup& group : grouped.groups) {
        out << "*ELEMENT, TYPE=" << type << ", ELSET=" << (group.isNamed() ? nameOf(group.entity) : "Unnamed")
            << '\n';
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            out << grouped.order[i] + 1;
            for (const NodeId node : elements[grouped.order[i]].node) out << ", " << node.value + 1;
            out << '\n';
        }
    }
}

/// The nodes of each entity of this dimension, those on its boundary included.
template <std::size_t N>
void writeNodeSets(const std::vector<MeshElement<N>>& elements, FileBuffer& out)
{
    const EntityGroups grouped = groupByEntity(elements);
    for (const EntityGroup& group : grouped.groups) {
        if (!group.isNamed()) continue;
        std::vector<NodeId> nodes;
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            const auto& node = elements[grouped.order[i]].node;
            nodes.insert(nodes.end(), node.begin(), node.end());
        }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        out << "*NSET, NSET=" << nameOf(group.entity) << '\n';
        NumberList list(out);
        for (const NodeId node : nodes) list.add(node.value + 1);
        list.finish();
    }
}

/// Sides of elements, for loads: those of each edge of a plane mesh or of each face of a solid.
template <std::size_t N, class LabelOf>
void writeSurfaces(const std::vector<MeshElement<N>>& elements, const ElementSides& sides, LabelOf labelOf,
                   FileBuffer& out)
{
    const EntityGroups grouped = groupByEntity(elements);
    for (const EntityGroup& group : grouped.groups) {
        if (!group.isNamed()) continue;
        out << "*SURFACE, NAME=" << nameOf(group.entity) << ", TYPE=ELEMENT\n";
        for (std::uint32_t i = group.first; i < group.last; ++i) {
            for (const ElementSide& side : sides.of(grouped.order[i])) {
                out << side.element + 1 << ", S" << labelOf(side.side) << '\n';
            }
        }
    }
}

bool isInPlaneZ0(const ClassifiedMesh& mesh)
{
    return std::all_of(mesh.nodes.begin(), mesh.nodes.end(),
                       [](const MeshNode& node) { return node.position.z == 0.0; });
}

}  // namespace

/// Elements of the highest dimension only: solid elements, plane stress elements where the mesh lies in z = 0, else shells.
Result<void> writeAbaqusInp(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    if (mesh.tets.empty() && mesh.triangles.empty()) {
        return Error{ErrorCode::InvalidArgument,
                     "the mesh has no triangles and no tetrahedra to write as INP",
                     {},
                     {},
                     {}};
    }
    out << "*HEADING\nmesh, unit " << mesh.unit << "\n*NODE, NSET=Nall\n";
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3& p = mesh.nodes[NodeId(i)].position;
        out << i + 1;
        for (const double coordinate : {p.x, p.y, p.z}) out << ',' << shortNumber(coordinate, kLongestNumber);
        out << '\n';
    }
    const bool isPlane = isInPlaneZ0(mesh);
    if (!mesh.tets.empty()) {
        writeElements(mesh.tets, "C3D4", out);
    } else {
        writeElements(mesh.triangles, isPlane ? "CPS3" : "S3", out);
    }
    writeNodeSets(mesh.points, out);
    writeNodeSets(mesh.lines, out);
    if (!mesh.tets.empty()) {
        writeNodeSets(mesh.triangles, out);
        writeSurfaces(
            mesh.triangles, ElementSides::ofTriangles(mesh),
            [](std::uint8_t side) { return kTetSideLabel[side]; }, out);
    } else if (isPlane) {
        writeSurfaces(
            mesh.lines, ElementSides::ofLines(mesh), [](std::uint8_t side) { return side + 1; }, out);
    }
    return {};
}

}  // namespace mesher
