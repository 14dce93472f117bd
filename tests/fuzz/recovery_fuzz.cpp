// Constrained tetrahedralizations of random polyhedra, each fully checked. Round r has the seed S + r, so a run is continued
// with the seed that it prints, and a failing round is repeated alone.

#include "delaunay/constrained_check.h"
#include "delaunay/delaunay_check3d.h"
#include "support/poly_file.h"
#include "support/sample_surfaces.h"
#include "tetrahedralization/tetrahedralize.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace mesher {
namespace {

struct Totals
{
    std::uint64_t nodes = 0;
    std::uint64_t missingEdges = 0;
    std::uint64_t missingFacets = 0;
    std::uint64_t steiner = 0;
    std::uint64_t stars = 0;
    std::uint64_t left = 0;
    std::uint64_t nonDelaunay = 0;
    std::uint64_t withNonDelaunay = 0;
    std::uint64_t withSteiner = 0;
};

/// Turned planar faces are planar no more, by the last bit, and facets of theirs may then cross: not a fault.
std::string tryRound(std::uint64_t seed, bool isVerbose, const TetrahedralizationOptions& options,
                     Totals& totals, bool& isRefused)
{
    std::string name;
    test::SampleSurface sample = test::randomSurface(seed, name);
    if (sample.mesh.facets.empty()) return {};
    RunContext context;
    const auto result = tetrahedralize(sample.mesh, sample.sides, options, context);
    isRefused = !result;
    if (!result) return name + ": refused: " + describe(result.error());
    const TetrahedralizationCounts& counts = result->counts;
    if (!result->failures.empty()) return name + ": not recovered: " + describe(result->failures.front());
    for (const CheckReport& report :
         {checkTopology3d(result->tets.mesh()), checkConstraints(result->tets, sample.mesh),
          checkRegions(result->tets, sample.mesh, sample.sides)}) {
        if (!report.isValid()) return name + ": " + report.problem;
    }
    totals.nodes += counts.nodes;
    totals.missingEdges += counts.missingEdges;
    totals.missingFacets += counts.missingFacets;
    totals.steiner += counts.edgeSteiner + counts.facetSteiner;
    totals.stars += counts.starVertices;
    totals.left += counts.freeVerticesLeft;
    totals.nonDelaunay += counts.nonDelaunayFaces;
    totals.withNonDelaunay += counts.nonDelaunayFaces > 0 ? 1 : 0;
    totals.withSteiner += counts.edgeSteiner + counts.facetSteiner + counts.freeVerticesLeft > 0 ? 1 : 0;
    if (isVerbose) {
        std::printf("seed %llu %s: %u nodes, missing %u edges %u facets, flips %u %u, cavity %u, star %u, "
                    "Steiner %u %u, "
                    "left %u, non-Delaunay %llu\n",
                    static_cast<unsigned long long>(seed), name.c_str(), counts.nodes, counts.missingEdges,
                    counts.missingFacets, counts.edgesByFlips, counts.facetsByFlips, counts.facetsByCavity,
                    counts.facetsByStar, counts.edgeSteiner, counts.facetSteiner, counts.freeVerticesLeft,
                    static_cast<unsigned long long>(counts.nonDelaunayFaces));
    }
    return {};
}

int run(std::uint64_t seed, std::uint64_t rounds, bool isVerbose, const TetrahedralizationOptions& options)
{
    Totals totals;
    std::uint64_t failures = 0;
    for (std::uint64_t round = 0; round < rounds; ++round) {
        bool isRefused = false;
        const std::string problem = tryRound(seed + round, isVerbose, options, totals, isRefused);
        if (problem.empty()) continue;
        ++failures;
        std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed + round), problem.c_str());
    }
    std::printf(
        "%llu rounds, %llu failed; %llu nodes, missing edges %llu, facets %llu; Steiner points on the "
        "surface %llu, "
        "stars %llu, left inside %llu; in %llu rounds; faces not Delaunay %llu in %llu rounds; continue with "
        "--seed %llu\n",
        static_cast<unsigned long long>(rounds), static_cast<unsigned long long>(failures),
        static_cast<unsigned long long>(totals.nodes), static_cast<unsigned long long>(totals.missingEdges),
        static_cast<unsigned long long>(totals.missingFacets),
        static_cast<unsigned long long>(totals.steiner), static_cast<unsigned long long>(totals.stars),
        static_cast<unsigned long long>(totals.left), static_cast<unsigned long long>(totals.withSteiner),
        static_cast<unsigned long long>(totals.nonDelaunay),
        static_cast<unsigned long long>(totals.withNonDelaunay),
        static_cast<unsigned long long>(seed + rounds));
    return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace mesher

int main(int argc, char** argv)
{
    std::uint64_t seed = 1;
    std::uint64_t rounds = 100;
    bool isVerbose = false;
    mesher::TetrahedralizationOptions options;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--verbose") == 0) {
            isVerbose = true;
        } else if (std::strcmp(argv[i], "--seed") == 0 && i + 1 < argc) {
            seed = std::strtoull(argv[++i], nullptr, 10);
        } else if (std::strcmp(argv[i], "--rounds") == 0 && i + 1 < argc) {
            rounds = std::strtoull(argv[++i], nullptr, 10);
        } else if (std::strcmp(argv[i], "--poly") == 0 && i + 1 < argc) {
            std::string name;
            mesher::test::writePoly(mesher::test::randomSurface(seed, name).mesh, argv[++i]);
            return 0;
        } else if (std::strcmp(argv[i], "--depth") == 0 && i + 1 < argc) {
            options.flipDepth = std::atoi(argv[++i]);
        } else {
            std::fprintf(
                stderr,
                "usage: recovery_fuzz [--seed S] [--rounds N] [--depth D] [--verbose] [--poly FILE]\n");
            return 2;
        }
    }
    return mesher::run(seed, rounds, isVerbose, options);
}
