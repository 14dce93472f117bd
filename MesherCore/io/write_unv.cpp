#include "io/entity_groups.h"
#include "io/format_writers.h"
#include "io/group_numbers.h"

#include <charconv>

namespace mesher {

namespace {

constexpr std::array<int, 5> kElementCode = {0, 0, 11, 91,
                                             111};  // rod, thin shell triangle, solid tetrahedron
constexpr int kElementsInGroup = 8;                 // the code of "element" in a group
constexpr int kNodesInGroup = 7;

/// A number right-aligned in a column of ten.
template <class Integer>
void writeColumn(Integer value, FileBuffer& out)
{
    char digits[24];
    const char* end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
    for (auto width = end - digits; width < 10; ++width) out << ' ';
    out << std::string_view(digits, static_cast<std::size_t>(end - digits));
}

template <class... Integers>
void writeRow(FileBuffer& out, Integers... values)
{
    (writeColumn(values, out), ...);
    out << '\n';
}

/// FORTRAN's D25.16: seventeen digits, enough to read the same double.
void writeCoordinate(double value, FileBuffer& out)
{
    char digits[32];
    char* end =
        std::to_chars(std::begin(digits), std::end(digits), value + 0.0, std::chars_format::scientific, 16)
            .ptr;
    for (auto width = end - digits; width < 25; ++width) out << ' ';
    for (char* c = digits; c != end; ++c) out << (*c == 'e' ? 'D' : *c);
}

void writeNodes(const ClassifiedMesh& mesh, FileBuffer& out)
{
    out << "    -1\n  2411\n";
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        writeRow(out, i + 1, 1, 1, 11);
        const Vec3& p = mesh.nodes[NodeId(i)].position;
        writeCoordinate(p.x, out);
        writeCoordinate(p.y, out);
        writeCoordinate(p.z, out);
        out << '\n';
    }
    out << "    -1\n";
}

template <std::size_t N>
void writeElements(const std::vector<MeshElement<N>>& elements, std::size_t firstLabel, FileBuffer& out)
{
    for (std::size_t i = 0; i < elements.size(); ++i) {
        writeRow(out, firstLabel + i, kElementCode[N], 1, 1, 7, N);
        if constexpr (N == 2) writeRow(out, 0, 0, 0);  // orientation and cross-sections, which every rod has
        for (const NodeId node : elements[i].node) writeColumn(node.value + 1, out);
        out << '\n';
    }
}

/// Groups of dataset 2467, two members a line.
class GroupWriter
{
public:
    GroupWriter(const GroupNumbers& numbers, FileBuffer& out) : numbers_(numbers), out_(out) {}

    template <std::size_t N, class LabelOf>
    void write(const std::vector<MeshElement<N>>& elements, int memberCode, LabelOf labelOf)
    {
        const EntityGroups grouped = groupByEntity(elements);
        for (const EntityGroup& group : grouped.groups) {
            const std::uint32_t number = numbers_.numberOf(group.entity);
            if (number == 0) continue;
            writeRow(out_, number, 0, 0, 0, 0, 0, 0, group.size());
            out_ << nameOf(group.entity) << '\n';
            for (std::uint32_t i = group.first; i < group.last; ++i) {
                writeColumn(memberCode, out_);
                writeColumn(labelOf(grouped.order[i]), out_);
                writeColumn(0, out_);
                writeColumn(0, out_);
                if ((i - group.first) % 2 == 1 || i + 1 == group.last) out_ << '\n';
            }
        }
    }

private:
    const GroupNumbers& numbers_;
    FileBuffer& out_;
};

}  // namespace

/// Lines and points are there only as groups: to a solver a line beside a solid is a rod, and some readers end at groups of them.
Result<void> writeUnv(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options)
{
    const GroupNumbers numbers(mesh, options.groups);
    const bool hasLines = numbers.isGrouped(1);
    const std::size_t firstTriangle = hasLines ? mesh.lines.size() + 1 : 1;
    const std::size_t firstTet = firstTriangle + mesh.triangles.size();
    writeNodes(mesh, out);
    out << "    -1\n  2412\n";
    if (hasLines) writeElements(mesh.lines, 1, out);
    writeElements(mesh.triangles, firstTriangle, out);
    writeElements(mesh.tets, firstTet, out);
    out << "    -1\n    -1\n  2467\n";
    GroupWriter groups(numbers, out);
    groups.write(mesh.tets, kElementsInGroup, [&](std::uint32_t i) { return firstTet + i; });
    groups.write(mesh.triangles, kElementsInGroup, [&](std::uint32_t i) { return firstTriangle + i; });
    groups.write(mesh.lines, kElementsInGroup, [](std::uint32_t i) { return i + 1; });
    groups.write(mesh.points, kNodesInGroup,
                 [&](std::uint32_t i) { return mesh.points[i].node[0].value + 1; });
    out << "    -1\n";
    return {};
}

}  // namespace mesher
