// Tetrahedralizes random points of the unit cube, has the result checked, and shows that it does not depend on the
// order of the points: triangulate_points [COUNT [SEED]]

#include "base/random.h"
#include "base/run_context.h"
#include "delaunay/delaunay3d.h"
#include "delaunay/delaunay_check3d.h"
#include "delaunay/mesh_hash.h"

#include <algorithm>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

struct Arguments
{
    std::uint32_t count = 20'000;
    std::uint64_t seed = 1;
};

template <class Number>
bool parseNumber(const char* text, Number& number)
{
    const char* end = text + std::strlen(text);
    const std::from_chars_result read = std::from_chars(text, end, number);
    return read.ec == std::errc() && read.ptr == end;
}

bool parseArguments(int argumentCount, char** arguments, Arguments& parsed)
{
    if (argumentCount > 3) return false;
    if (argumentCount > 1 && !parseNumber(arguments[1], parsed.count)) return false;
    return argumentCount < 3 || parseNumber(arguments[2], parsed.seed);
}

std::vector<mesher::Vec3> randomPoints(const Arguments& arguments)
{
    mesher::Random random(arguments.seed);
    std::vector<mesher::Vec3> points(arguments.count);
    for (mesher::Vec3& point : points) {
        point.x = random.unit();
        point.y = random.unit();
        point.z = random.unit();
    }
    return points;
}

/// False, with the reason on stderr, if the points are refused.
bool triangulate(const std::vector<mesher::Vec3>& points, mesher::Delaunay3d& delaunay)
{
    mesher::RunContext context;
    const mesher::Result<mesher::BulkInsertion3d> inserted = delaunay.insertPoints(points, {}, context);
    if (!inserted) std::fprintf(stderr, "%s\n", mesher::describe(inserted.error()).c_str());
    return inserted.hasValue();
}

bool isSound(const mesher::Triangulation3d& mesh)
{
    const mesher::CheckReport topology = mesher::checkTopology3d(mesh);
    const mesher::CheckReport delaunay = mesher::checkDelaunay3d(mesh, mesher::DelaunayScope::Local);
    if (!topology.isValid()) std::fprintf(stderr, "topology: %s\n", topology.problem.c_str());
    if (!delaunay.isValid()) std::fprintf(stderr, "Delaunay property: %s\n", delaunay.problem.c_str());
    return topology.isValid() && delaunay.isValid();
}

}  // namespace

int main(int argumentCount, char** argumentValues)
{
    Arguments arguments;
    if (!parseArguments(argumentCount, argumentValues, arguments)) {
        std::fprintf(stderr, "usage: %s [COUNT [SEED]]\n", argumentValues[0]);
        return 2;
    }
    std::vector<mesher::Vec3> points = randomPoints(arguments);
    mesher::Delaunay3d delaunay;
    if (!triangulate(points, delaunay)) return 1;

    const mesher::Triangulation3d& mesh = delaunay.triangulation();
    const std::uint32_t tetCount = mesh.finiteTetCount();
    const std::uint64_t hash = mesher::meshHash3d(mesh);
    std::printf("%" PRIu32 " points, %" PRIu32 " tetrahedra, %" PRIu32
                " hull triangles, %.1f bytes per tetrahedron\n",
                mesh.vertexCount(), tetCount, mesh.tetCount() - tetCount,
                tetCount == 0 ? 0.0 : static_cast<double>(delaunay.bytes()) / tetCount);
    if (!isSound(mesh)) return 1;
    std::printf("topology and Delaunay property verified exactly\n");

    std::reverse(points.begin(), points.end());
    mesher::Delaunay3d reversed;
    if (!triangulate(points, reversed)) return 1;
    if (mesher::meshHash3d(reversed.triangulation()) != hash) {
        std::fprintf(stderr, "the reversed points gave other tetrahedra\n");
        return 1;
    }
    std::printf("the same tetrahedra from the reversed points, hash %016" PRIx64 "\n", hash);
    return 0;
}
