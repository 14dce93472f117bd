// Times the tetrahedralization of a surface mesh: recovery_ours torus|sphere|cells|box SIZE [--kept | --poly FILE]. One line of JSON;
// with --poly the surface goes to a file for TetGen instead (tetgen -pM FILE), each triangle a facet of its own.

#include "delaunay/constrained_check.h"
#include "support/poly_file.h"
#include "support/sample_surfaces.h"
#include "tetrahedralization/tetrahedralize.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>

namespace {

using namespace mesher;

test::SampleSurface surfaceNamed(std::string_view name, int size)
{
    if (name == "torus") return test::torusSurface(size * 2, size, 0.1, 1);
    if (name == "sphere") return test::sphereSurface(size, 0.0, 1);
    if (name == "cells") return test::cellSurface({size, size, size}, 1, 0.1, 1);
    return test::flippedBoxSurface(size, size * size * 3, {1.0, 0.7, 0.1}, 1);
}

}  // namespace

int main(int count, char** words)
{
    const bool isKept = count == 4 && std::string_view(words[3]) == "--kept";
    if (count != 3 && !isKept && !(count == 5 && std::string_view(words[3]) == "--poly")) {
        std::fprintf(stderr, "recovery_ours torus|sphere|cells|box SIZE [--kept | --poly FILE]\n");
        return 2;
    }
    test::SampleSurface sample = surfaceNamed(words[1], std::atoi(words[2]));
    if (count == 5) {
        test::writePoly(sample.mesh, words[4]);
        return 0;
    }
    const std::size_t facets = sample.mesh.facets.size();
    RunContext context;
    TetrahedralizationOptions options;
    if (isKept) options.scaffold = SurfaceScaffold::Kept;
    const std::clock_t start = std::clock();
    const auto result = tetrahedralize(sample.mesh, sample.sides, options, context);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (!result) {
        std::fprintf(stderr, "%s\n", describe(result.error()).c_str());
        return 1;
    }
    const TetrahedralizationCounts& c = result->counts;
    std::printf(
        "{\"facets\": %zu, \"nodes\": %u, \"scaffold\": %u, \"missing_edges\": %u, \"missing_facets\": %u, "
        "\"steiner\": %u, \"stars\": %u, \"free_left\": %u, \"failures\": %zu, \"delaunay_flips\": %llu, "
        "\"non_delaunay\": %llu, \"seconds\": %.3f, \"facets_per_second\": %.0f}\n",
        facets, c.nodes, c.scaffoldPoints, c.missingEdges, c.missingFacets, c.edgeSteiner + c.facetSteiner,
        c.starVertices, c.freeVerticesLeft, result->failures.size(),
        static_cast<unsigned long long>(c.delaunayFlips), static_cast<unsigned long long>(c.nonDelaunayFaces),
        seconds, static_cast<double>(facets) / seconds);
    return 0;
}
