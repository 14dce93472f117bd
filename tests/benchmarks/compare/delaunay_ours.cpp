// The project's own kernel under the same conditions as the peers: delaunay_ours [--plain] POINTS.
// --plain inserts no scaffold points into samples of surfaces.

#include "base/run_context.h"
#include "delaunay/delaunay2d.h"
#include "delaunay/delaunay3d.h"
#include "measurement.h"

#include <string_view>
#include <vector>

namespace {

void printRefusal(const mesher::Error& error)
{
    std::fprintf(stderr, "%s\n", mesher::describe(error).c_str());
}

std::size_t finiteTriangleCount(const mesher::Triangulation2d& mesh)
{
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const mesher::TriangleId triangle(i);
        if (mesh.isAlive(triangle) && !mesh.triangle(triangle).isGhost()) ++count;
    }
    return count;
}

/// False if the kernel refuses the points.
bool triangulate2d(const compare::PointFile& input)
{
    std::vector<mesher::Vec2> points;
    points.reserve(input.count());
    for (std::size_t i = 0; i < input.count(); ++i) points.push_back({input.point(i)[0], input.point(i)[1]});

    compare::Measurement measurement;
    mesher::Delaunay2d delaunay;
    {
        const mesher::Result<mesher::BulkInsertion2d> inserted = delaunay.insertPoints(points);
        if (!inserted) {
            printRefusal(inserted.error());
            return false;
        }
    }
    measurement.stop();
    measurement.print(delaunay.mesh().vertexCount(), finiteTriangleCount(delaunay.mesh()), 0);
    return true;
}

/// False if the kernel refuses the points.
bool triangulate3d(const compare::PointFile& input, mesher::ScaffoldPolicy scaffold)
{
    std::vector<mesher::Vec3> points;
    points.reserve(input.count());
    for (std::size_t i = 0; i < input.count(); ++i) {
        const double* p = input.point(i);
        points.push_back({p[0], p[1], p[2]});
    }
    mesher::RunContext context;
    mesher::BulkInsertionOptions3d options;
    options.scaffold = scaffold;

    compare::Measurement measurement;
    mesher::Delaunay3d delaunay(context.seed());
    std::size_t scaffoldPoints = 0;
    {
        const mesher::Result<mesher::BulkInsertion3d> inserted =
            delaunay.insertPoints(points, options, context);
        if (!inserted) {
            printRefusal(inserted.error());
            return false;
        }
        scaffoldPoints = inserted->scaffoldPoints;
    }
    measurement.stop();
    measurement.print(delaunay.triangulation().vertexCount(), delaunay.triangulation().finiteTetCount(),
                      scaffoldPoints);
    return true;
}

}  // namespace

int main(int argumentCount, char** arguments)
{
    mesher::ScaffoldPolicy scaffold = mesher::ScaffoldPolicy::Automatic;
    if (argumentCount > 1 && std::string_view(arguments[1]) == "--plain") {
        scaffold = mesher::ScaffoldPolicy::None;
        arguments[1] = arguments[0];
        ++arguments;
        --argumentCount;
    }
    compare::PointFile input;
    if (!compare::readArgument(argumentCount, arguments, input)) return 2;
    const bool isDone = input.dimension == 2 ? triangulate2d(input) : triangulate3d(input, scaffold);
    return isDone ? 0 : 1;
}
