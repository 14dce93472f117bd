// Times the mesher on a square or an annulus at a uniform size: planar_ours square|annulus SIZE. One line of JSON.

#include "base/run_context.h"
#include "sizing/uniform_size.h"
#include "support/planar_examples.h"
#include "triangulation2d/triangulate_planar.h"

#include <cstdlib>
#include <iostream>
#include <string_view>

int main(int count, char** words)
{
    if (count != 3) {
        std::cerr << "planar_ours square|annulus SIZE\n";
        return 2;
    }
    const bool isSquare = std::string_view(words[1]) == "square";
    const mesher::UniformSize size(std::strtod(words[2], nullptr));
    mesher::PlanarOptions options;
    options.refinement.sizing.field = &size;
    mesher::RunContext context;
    const auto complex = isSquare ? mesher::test::unitSquare() : mesher::test::annulus();
    const auto result = mesher::triangulatePlanar(complex, options, context);
    if (!result) {
        std::cerr << mesher::describe(result.error()) << '\n';
        return 1;
    }
    const mesher::PlanarTimes& s = result->seconds;
    const double seconds = s.sampling + s.enrichment + s.initialTriangulation + s.refinement;
    const auto triangles = static_cast<double>(result->counts.triangles);
    std::cout << "{\"triangles\": " << result->counts.triangles
              << ", \"vertices\": " << result->counts.vertices << ", \"seconds\": " << seconds
              << ", \"triangles_per_second\": " << triangles / seconds
              << ", \"enrichment_share\": " << (s.sampling + s.enrichment) / seconds
              << ", \"bytes_per_triangle\": "
              << static_cast<double>(result->triangulation.mesh().bytes()) / triangles << "}\n";
    return 0;
}
