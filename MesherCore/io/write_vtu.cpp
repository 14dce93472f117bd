#include "io/base64.h"
#include "io/entity_groups.h"
#include "io/format_writers.h"
#include "io/group_numbers.h"

#include <bit>
#include <functional>

namespace mesher {

namespace {

static_assert(std::endian::native == std::endian::little, "the file declares little endian");

/// One array of the file: what its tag says, its size, and how to produce its values.
struct VtuArray
{
    std::string_view type;
    std::string_view name;
    int components = 1;
    std::size_t byteCount = 0;
    std::function<void(Base64Encoder&)> append;
};

/// Calls visit(element, VTK's number of the cell type) for all elements: points, lines, triangles, tets.
template <class Visit>
void forElements(const ClassifiedMesh& mesh, Visit visit)
{
    for (const auto& element : mesh.points) visit(element, std::uint8_t{1});
    for (const auto& element : mesh.lines) visit(element, std::uint8_t{3});
    for (const auto& element : mesh.triangles) visit(element, std::uint8_t{5});
    for (const auto& element : mesh.tets) visit(element, std::uint8_t{10});
}

std::size_t cellCount(const ClassifiedMesh& mesh)
{
    return mesh.points.size() + mesh.lines.size() + mesh.triangles.size() + mesh.tets.size();
}

/// The number of people, from 1; 0 without an entity.
std::int32_t numberOf(EntityRef entity) { return static_cast<std::int32_t>(entity.index + 1); }

std::vector<VtuArray> nodeArrays(const ClassifiedMesh& mesh)
{
    const std::size_t n = mesh.nodes.size();
    return {
        {"Int32", "entity", 1, 4 * n,
         [&](Base64Encoder& out) {
             for (const MeshNode& node : mesh.nodes) out.appendValue(numberOf(node.entity));
         }},
        {"UInt8", "dimension", 1, n,
         [&](Base64Encoder& out) {
             for (const MeshNode& node : mesh.nodes) out.appendValue(node.entity.dimension);
         }},
        {"Float64", "parameters", 2, 16 * n,
         [&](Base64Encoder& out) {
             for (const MeshNode& node : mesh.nodes) {
                 out.appendValue(node.parameters.x);
                 out.appendValue(node.parameters.y);
             }
         }},
    };
}

std::vector<VtuArray> cellArrays(const ClassifiedMesh& mesh, const GroupNumbers& numbers)
{
    return {
        {"Int32", "group", 1, 4 * cellCount(mesh),
         [&](Base64Encoder& out) {
             forElements(mesh, [&](const auto& element, std::uint8_t) {
                 out.appendValue(static_cast<std::int32_t>(numbers.numberOf(element.entity)));
             });
         }},
        {"Int32", "entity", 1, 4 * cellCount(mesh),
         [&](Base64Encoder& out) {
             forElements(
                 mesh, [&](const auto& element, std::uint8_t) { out.appendValue(numberOf(element.entity)); });
         }},
        {"UInt8", "dimension", 1, cellCount(mesh),
         [&](Base64Encoder& out) {
             forElements(
                 mesh, [&](const auto& element, std::uint8_t) { out.appendValue(element.entity.dimension); });
         }},
    };
}

std::vector<VtuArray> positionArrays(const ClassifiedMesh& mesh)
{
    return {{"Float64", "Points", 3, 24 * mesh.nodes.size(), [&](Base64Encoder& out) {
                 for (const MeshNode& node : mesh.nodes) {
                     out.appendValue(node.position.x);
                     out.appendValue(node.position.y);
                     out.appendValue(node.position.z);
                 }
             }}};
}

std::vector<VtuArray> topologyArrays(const ClassifiedMesh& mesh)
{
    const std::size_t references =
        mesh.points.size() + 2 * mesh.lines.size() + 3 * mesh.triangles.size() + 4 * mesh.tets.size();
    return {
        {"Int64", "connectivity", 1, 8 * references,
         [&](Base64Encoder& out) {
             forElements(mesh, [&](const auto& element, std::uint8_t) {
                 for (const NodeId node : element.node)
                     out.appendValue(static_cast<std::int64_t>(node.value));
             });
         }},
        {"Int64", "offsets", 1, 8 * cellCount(mesh),
         [&](Base64Encoder& out) {
             std::int64_t end = 0;
             forElements(mesh, [&](const auto& element, std::uint8_t) {
                 end += static_cast<std::int64_t>(element.node.size());
                 out.appendValue(end);
             });
         }},
        {"UInt8", "types", 1, cellCount(mesh),
         [&](Base64Encoder& out) {
             forElements(mesh, [&](const auto&, std::uint8_t type) { out.appendValue(type); });
         }},
    };
}

struct VtuSection
{
    std::string_view name;
    std::vector<VtuArray> arrays;
};

void writeTags(const VtuSection& section, std::size_t& offset, FileBuffer& out)
{
    out << "      <" << section.name << ">\n";
    for (const VtuArray& array : section.arrays) {
        out << "        <DataArray type=\"" << array.type << "\" Name=\"" << array.name << '"';
        if (array.components > 1) out << " NumberOfComponents=\"" << array.components << '"';
        out << " format=\"appended\" offset=\"" << offset << "\"/>\n";
        offset += base64Length(sizeof(std::uint64_t) + array.byteCount);
    }
    out << "      </" << section.name << ">\n";
}

template <std::size_t N>
void writeNames(const std::vector<MeshElement<N>>& elements, const GroupNumbers& numbers, FileBuffer& out)
{
    for (const EntityGroup& group : groupByEntity(elements).groups) {
        if (!group.isNamed()) continue;
        out << "      <DataArray type=\"Int32\" Name=\"" << nameOf(group.entity)
            << "\" NumberOfTuples=\"2\" format=\"ascii\">" << numbers.numberOf(group.entity) << ' ' << N - 1
            << "</DataArray>\n";
    }
}

/// The names of the groups: an array of each name with its number, which cells have in their array 'group', and its dimension.
/// Arrays of text would say it more directly, and are beyond some readers.
void writeNames(const ClassifiedMesh& mesh, const GroupNumbers& numbers, FileBuffer& out)
{
    out << "    <FieldData>\n";
    writeNames(mesh.tets, numbers, out);
    writeNames(mesh.triangles, numbers, out);
    writeNames(mesh.lines, numbers, out);
    writeNames(mesh.points, numbers, out);
    out << "    </FieldData>\n";
}

}  // namespace

Result<void> writeVtu(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    const GroupNumbers numbers(mesh, GroupChoice::All);
    const std::vector<VtuSection> sections = {{"PointData", nodeArrays(mesh)},
                                              {"CellData", cellArrays(mesh, numbers)},
                                              {"Points", positionArrays(mesh)},
                                              {"Cells", topologyArrays(mesh)}};
    out << "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n"
           "  <UnstructuredGrid>\n";
    writeNames(mesh, numbers, out);
    out << "    <Piece NumberOfPoints=\"" << mesh.nodes.size() << "\" NumberOfCells=\"" << cellCount(mesh)
        << "\">\n";
    std::size_t offset = 0;
    for (const VtuSection& section : sections) writeTags(section, offset, out);
    out << "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"base64\">\n_";
    for (const VtuSection& section : sections) {
        for (const VtuArray& array : section.arrays) {
            Base64Encoder encoder(out);
            encoder.appendValue(static_cast<std::uint64_t>(array.byteCount));
            array.append(encoder);
            encoder.finish();
        }
    }
    out << "\n  </AppendedData>\n</VTKFile>\n";
    return {};
}

}  // namespace mesher
