#include "io/format_writers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>

namespace mesher {

namespace {

template <class Visit>
void forElements(const ClassifiedMesh& mesh, Visit visit)
{
    for (const auto& element : mesh.points) visit(element, 1);
    for (const auto& element : mesh.lines) visit(element, 3);
    for (const auto& element : mesh.triangles) visit(element, 5);
    for (const auto& element : mesh.tets) visit(element, 10);
}

/// Values as text, one item (point, cell) a line.
struct TextValues
{
    static constexpr std::string_view kKind = "ASCII";
    FileBuffer& out;

    template <class T>
    void put(T value)
    {
        out << value << ' ';
    }
    void endItem() { out << '\n'; }
};

/// Values in big-endian order, as legacy VTK wants them.
struct BinaryValues
{
    static constexpr std::string_view kKind = "BINARY";
    FileBuffer& out;

    template <class T>
    void put(T value)
    {
        auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if constexpr (std::endian::native == std::endian::little) std::reverse(bytes.begin(), bytes.end());
        out.append(bytes);
    }
    void endItem() {}
};

template <class Values>
void writeCells(const ClassifiedMesh& mesh, std::size_t cellCount, FileBuffer& out)
{
    Values values{out};
    const std::size_t references =
        mesh.points.size() + 2 * mesh.lines.size() + 3 * mesh.triangles.size() + 4 * mesh.tets.size();
    out << "CELLS " << cellCount << ' ' << cellCount + references << '\n';
    forElements(mesh, [&](const auto& element, int) {
        values.put(static_cast<std::int32_t>(element.node.size()));
        for (const NodeId node : element.node) values.put(static_cast<std::int32_t>(node.value));
        values.endItem();
    });
    out << "\nCELL_TYPES " << cellCount << '\n';
    forElements(mesh, [&](const auto&, int type) {
        values.put(static_cast<std::int32_t>(type));
        values.endItem();
    });
}

template <class Values>
void writeCellData(const ClassifiedMesh& mesh, std::size_t cellCount, FileBuffer& out)
{
    Values values{out};
    // Of several SCALARS most readers keep one; arrays of a FIELD are all kept.
    out << "\nCELL_DATA " << cellCount << "\nFIELD FieldData 2\nentity 1 " << cellCount << " int\n";
    forElements(mesh, [&](const auto& element, int) {
        values.put(static_cast<std::int32_t>(element.entity.index + 1));
        values.endItem();
    });
    out << "\ndimension 1 " << cellCount << " int\n";
    forElements(mesh, [&](const auto& element, int) {
        values.put(static_cast<std::int32_t>(element.entity.dimension));
        values.endItem();
    });
    out << '\n';
}

template <class Values>
void writePointData(const ClassifiedMesh& mesh, FileBuffer& out)
{
    Values values{out};
    const std::size_t count = mesh.nodes.size();
    out << "\nPOINT_DATA " << count << "\nFIELD FieldData 3\nentity 1 " << count << " int\n";
    for (const MeshNode& node : mesh.nodes) {
        values.put(static_cast<std::int32_t>(node.entity.index + 1));
        values.endItem();
    }
    out << "\ndimension 1 " << count << " int\n";
    for (const MeshNode& node : mesh.nodes) {
        values.put(static_cast<std::int32_t>(node.entity.dimension));
        values.endItem();
    }
    out << "\nparameters 2 " << count << " double\n";
    for (const MeshNode& node : mesh.nodes) {
        values.put(node.parameters.x);
        values.put(node.parameters.y);
        values.endItem();
    }
    out << '\n';
}

/// The second line of the file is at most 256 characters of text.
std::string titleLine(const ClassifiedMesh& mesh)
{
    std::string title = mesh.title.empty() ? "mesh" : mesh.title.substr(0, 200);
    std::replace_if(
        title.begin(), title.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return title + ", unit " + mesh.unit.substr(0, 20);
}

template <class Values>
Result<void> write(const ClassifiedMesh& mesh, FileBuffer& out)
{
    Values values{out};
    out << "# vtk DataFile Version 3.0\n"
        << titleLine(mesh) << '\n'
        << Values::kKind << "\nDATASET UNSTRUCTURED_GRID\n";
    out << "POINTS " << mesh.nodes.size() << " double\n";
    for (const MeshNode& node : mesh.nodes) {
        values.put(node.position.x);
        values.put(node.position.y);
        values.put(node.position.z);
        values.endItem();
    }
    out << '\n';
    const std::size_t cellCount =
        mesh.points.size() + mesh.lines.size() + mesh.triangles.size() + mesh.tets.size();
    writeCells<Values>(mesh, cellCount, out);
    writeCellData<Values>(mesh, cellCount, out);
    writePointData<Values>(mesh, out);
    return {};
}

}  // namespace

Result<void> writeVtkText(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    return write<TextValues>(mesh, out);
}
Result<void> writeVtkBinary(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    return write<BinaryValues>(mesh, out);
}

}  // namespace mesher
