// TetGen's incremental Delaunay tetrahedralization alone, called stage by stage, so that neither the conversion of its
// result nor any output is timed.

#include "measurement.h"

#include <tetgen.h>

int main(int argumentCount, char** arguments)
{
    compare::PointFile input;
    if (!compare::readArgument(argumentCount, arguments, input)) return 2;
    if (input.dimension != 3) {
        std::fprintf(stderr, "%s: TetGen triangulates three-dimensional points only\n", arguments[0]);
        return 2;
    }

    tetgenio points;
    points.numberofpoints = static_cast<int>(input.count());
    points.pointlist = input.coordinates.data();
    tetgenbehavior behavior;
    char switches[] = "Q";
    behavior.parse_commandline(switches);

    compare::Measurement measurement;
    tetgenmesh mesh;
    mesh.b = &behavior;
    mesh.in = &points;
    mesh.initializepools();
    mesh.transfernodes();
    exactinit(behavior.verbose, behavior.noexact, behavior.nostaticfilter, mesh.xmax - mesh.xmin,
              mesh.ymax - mesh.ymin, mesh.zmax - mesh.zmin);
    clock_t ignoredClock = 0;
    mesh.incrementaldelaunay(ignoredClock);
    measurement.stop();

    const long vertices = mesh.points->items - mesh.dupverts;
    const long tetrahedra = mesh.tetrahedrons->items - mesh.hullsize;
    measurement.print(static_cast<std::size_t>(vertices), static_cast<std::size_t>(tetrahedra), 0);
    points.pointlist = nullptr;  // owned by `input`, not by tetgenio
    return 0;
}
