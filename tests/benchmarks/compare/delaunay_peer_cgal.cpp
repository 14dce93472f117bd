// CGAL's Delaunay triangulations as its manual recommends them for speed: the inexact-constructions kernel, and the
// points inserted as one range, which CGAL sorts spatially.

#include "measurement.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

void triangulate2d(const compare::PointFile& input)
{
    std::vector<Kernel::Point_2> points;
    for (std::size_t i = 0; i < input.count(); ++i) points.emplace_back(input.point(i)[0], input.point(i)[1]);

    compare::Measurement measurement;
    CGAL::Delaunay_triangulation_2<Kernel> triangulation;
    triangulation.insert(points.begin(), points.end());
    measurement.stop();
    measurement.print(triangulation.number_of_vertices(), triangulation.number_of_faces(), 0);
}

void triangulate3d(const compare::PointFile& input)
{
    std::vector<Kernel::Point_3> points;
    for (std::size_t i = 0; i < input.count(); ++i) {
        const double* p = input.point(i);
        points.emplace_back(p[0], p[1], p[2]);
    }

    compare::Measurement measurement;
    CGAL::Delaunay_triangulation_3<Kernel> triangulation;
    triangulation.insert(points.begin(), points.end());
    measurement.stop();
    measurement.print(triangulation.number_of_vertices(), triangulation.number_of_finite_cells(), 0);
}

}  // namespace

int main(int argumentCount, char** arguments)
{
    compare::PointFile input;
    if (!compare::readArgument(argumentCount, arguments, input)) return 2;
    if (input.dimension == 2) {
        triangulate2d(input);
    } else {
        triangulate3d(input);
    }
    return 0;
}
