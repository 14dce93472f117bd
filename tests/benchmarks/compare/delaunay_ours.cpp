// The project's own kernel under the same conditions as the peers: delaunay_ours [--plain] POINTS.
// --plain inserts no scaffold points into samples of surfaces.

#include "base/run_context.h"
#include "delaunay/delaunay3d.h"
#include "measurement.h"

#include <string_view>
#include <vector>

namespace {

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
            std::fprintf(stderr, "%s\n", mesher::describe(inserted.error()).c_str());
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
    if (input.dimension != 3) {
        std::fprintf(stderr, "%s: three-dimensional points only\n", arguments[0]);
        return 2;
    }
    return triangulate3d(input, scaffold) ? 0 : 1;
}
