// Times the refinement of a solid at a uniform size, its surface sampled at about that size:
// refinement_ours box|sphere|cylinder|torus|wedge SIZE [q1…q8] [--frozen] [--features]. One line of JSON.
// SIZE 0 refines for quality alone, from a coarse sample.

#include "base/run_context.h"
#include "quality/tet_measures.h"
#include "refinement/refine_volume.h"
#include "refinement/refinement_check.h"
#include "sizing/uniform_size.h"
#include "support/sampled_solids.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numbers>
#include <string_view>
#include <sys/resource.h>

namespace {

double userCpuSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

mesher::test::SampledSolid make(std::string_view shape, double size)
{
    const double h = size > 0.0 ? size : 0.25;
    const auto along = [&](double extent) {
        return static_cast<std::uint32_t>(std::max(1.0, extent / h + 0.5));
    };
    if (shape == "box") return mesher::test::sampledBox({1, 1, 1}, size > 0.0 ? along(1.0) : 1);
    if (shape == "sphere")
        return mesher::test::sampledSphere(1.0, along(4.0 * std::numbers::pi / (0.87 * h)));
    if (shape == "cylinder") return mesher::test::sampledCylinder(1.0, 2.0, along(2.0 * std::numbers::pi));
    if (shape == "torus") return mesher::test::sampledTorus(2.0, 1.0, along(2.0 * std::numbers::pi));
    return mesher::test::sampledWedge(2.0, 1.0, 2.0, along(2.0));
}

}  // namespace

int main(int count, char** words)
{
    if (count < 3) {
        std::cerr << "refinement_ours SHAPE SIZE [q1…q8] [--frozen] [--features]\n";
        return 2;
    }
    const double size = std::strtod(words[2], nullptr);
    mesher::test::SampledSolid solid = make(words[1], size);
    const mesher::UniformSize field(size);
    mesher::RefineVolumeOptions options;
    if (size > 0.0) {
        options.sizing.field = &field;
        options.sizing.usesLocalFeatureSize = false;
    }
    for (int i = 3; i < count; ++i) {
        const std::string_view word = words[i];
        if (word == "--frozen") options.boundary = mesher::BoundaryPolicy::Frozen;
        if (word == "--features") options.sizing.usesLocalFeatureSize = true;
        if (const auto measure = mesher::tetMeasureOf(word)) options.quality.measure = *measure;
    }
    mesher::RunContext context;
    const double start = userCpuSeconds();
    const auto result = mesher::refineVolume(solid.tetrahedralization, *solid.splitter, options, context);
    const double seconds = userCpuSeconds() - start;
    if (!result) {
        std::cerr << mesher::describe(result.error()) << '\n';
        return 1;
    }
    const mesher::Triangulation3d& mesh = solid.tetrahedralization.mesh();
    double least = 180.0;
    double most = 0.0;
    double volume = 0.0;
    double edges = 0.0;
    std::uint64_t below18 = 0;
    std::uint64_t above155 = 0;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const mesher::TetId tet(i);
        if (!mesh.isAlive(tet) || mesh.isGhostTet(tet) || mesh.region(tet) == mesher::kExteriorRegion)
            continue;
        const auto& v = mesh.tet(tet).vertex;
        const mesher::TetCorners corners{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]),
                                         mesh.position(v[3])};
        const auto angles = mesher::dihedralAngles(corners);
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        least = std::min(least, *low);
        most = std::max(most, *high);
        below18 += *low < 18.0 ? 1u : 0u;
        above155 += *high > 155.0 ? 1u : 0u;
        volume += mesher::sixfoldVolume(corners) / 6.0;
        for (const auto& [a, b] : mesher::kTetEdgeCorners)
            edges += mesher::length(corners[a] - corners[b]) / 6.0;
    }
    std::map<int, std::uint64_t> reasons;
    for (const auto& left : result->left) ++reasons[static_cast<int>(left.reason)];
    const auto tets = static_cast<double>(result->tets);
    const auto& c = result->counts;
    std::cout << "{\"tets\": " << result->tets << ", \"vertices\": " << result->vertices << ", \"stop\": \""
              << mesher::nameOf(result->stopReason) << "\", \"seconds\": " << seconds
              << ", \"tets_per_second\": " << (seconds > 0.0 ? tets / seconds : 0.0) << ", \"dihedral\": ["
              << least << ", " << most << "], \"outside_18_155\": [" << below18 << ", " << above155
              << "], \"volume_error\": " << volume / solid.volume - 1.0
              << ", \"mean_edge_over_size\": " << (size > 0.0 ? edges / tets / size : 0.0)
              << ", \"sinks\": " << c.sinkInsertions << ", \"size\": " << c.sizeInsertions
              << ", \"quality\": " << c.qualityInsertions << ", \"segments\": " << c.segmentSplits
              << ", \"facets\": " << c.facetSplits << ", \"rejected\": " << c.rejectedCentres
              << ", \"refused\": [" << c.refusedSegments << ", " << c.refusedFacets
              << "], \"aborted\": " << c.abortedInsertions << ", \"short\": " << c.shortInsertions
              << ", \"repairs\": " << c.cavityRepairs << ", \"neighbour\": " << c.neighbourSplits
              << ", \"deleted\": " << c.boundary.deletedVertices << ", \"kept\": " << c.boundary.keptVertices
              << ", \"least\": " << c.boundary.leastExtents << ", \"blocked\": " << c.boundary.blockedCavities
              << ", \"inconsistent\": " << c.boundary.inconsistentSplits << ", \"left\": {";
    bool isFirst = true;
    for (const auto& [reason, number] : reasons) {
        std::cout << (isFirst ? "" : ", ") << '"' << reason << "\": " << number;
        isFirst = false;
    }
    const auto report = mesher::checkRefinement(solid.tetrahedralization, solid.splitter->mesh());
    std::cout << "}, \"check\": \"" << report.problem << "\"}\n";
    return report.isValid() ? 0 : 1;
}
