#include "io/write_curved_boundary.h"

#include "io/file_buffer.h"

namespace mesher {

namespace {

void writeVector(const Vec3& v, FileBuffer& out) { out << '[' << v.x << ", " << v.y << ", " << v.z << ']'; }

void writePoints(const std::vector<CurvedBoundaryPoint>& points, FileBuffer& out)
{
    out << '[';
    const char* separator = "";
    for (const CurvedBoundaryPoint& point : points) {
        out << separator << "{\"parameter\": " << point.parameter << ", \"point\": ";
        writeVector(point.position, out);
        out << ", \"normal\": ";
        writeVector(point.normal, out);
        out << ", \"weight\": " << point.weight << ", \"curvature\": " << point.curvature << '}';
        separator = ", ";
    }
    out << ']';
}

void writeEdge(const CurvedBoundaryEdge& edge, FileBuffer& out)
{
    out << "  {\"curve\": \"" << nameOf(edge.curve) << "\", \"nodes\": [" << edge.node[0].value + 1 << ", "
        << edge.node[1].value + 1 << "], \"parameters\": [" << edge.parameter[0] << ", " << edge.parameter[1]
        << "], \"left\": \"" << nameOf(edge.left) << "\", \"right\": \"" << nameOf(edge.right)
        << "\",\n   \"gauss\": ";
    writePoints(edge.points, out);
    out << ",\n   \"halves\": [";
    writePoints(edge.halves[0], out);
    out << ", ";
    writePoints(edge.halves[1], out);
    out << "]}";
}

}  // namespace

Result<AtomicFile> prepareCurvedBoundary(const CurvedBoundary& boundary, const std::filesystem::path& path)
{
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) return file.error();
    FileBuffer out(*file);
    out << "{\"format\": \"mesher-curved-boundary\", \"version\": 1, \"unit\": \"" << boundary.unit
        << "\", \"order\": " << boundary.order << ",\n \"edges\": [";
    const char* separator = "\n";
    for (const CurvedBoundaryEdge& edge : boundary.edges) {
        out << separator;
        writeEdge(edge, out);
        separator = ",\n";
    }
    out << "\n]}\n";
    if (const Result<void> finished = out.finish(); !finished) return finished.error();
    if (const Result<void> prepared = file->prepare(); !prepared) return prepared.error();
    return file;
}

}  // namespace mesher
