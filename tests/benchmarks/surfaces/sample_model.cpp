// Samples the surfaces of a CAD file, checks the result and prints one line of JSON:
//     sample_model FILE [--share S] [--size H] [--rho R] [--turn N] [--sag D] [--lens A] [--threads N] [--angle A] [--max VERTICES] [--certificate ROUNDS] [--faces 1] [--off FILE]
// S is the wanted edge length as a share of the diagonal of the model's box. Samples per second are of CPU time, of everything
// but the final check; a certificate of -1 rounds leaves that out.

#include "base/run_context.h"
#include "brep/occt/read_model.h"
#include "quality/triangle_measures.h"
#include "surface_sampling/sample_surface.h"
#include "surface_sampling/surface_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

namespace {

using namespace mesher;

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Angles
{
    double least = 180.0;
    std::size_t below30 = 0;
    std::size_t below20 = 0;
    double longest = 0.0;
};

Angles measure(const SurfaceMesh& mesh)
{
    Angles angles;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        const TriangleShape shape =
            shapeOf({mesh.nodes[facet.node[0]].position, mesh.nodes[facet.node[1]].position,
                     mesh.nodes[facet.node[2]].position});
        angles.least = std::min(angles.least, shape.minAngle);
        angles.below30 += shape.minAngle < 29.999 ? 1 : 0;
        angles.below20 += shape.minAngle < 20.0 ? 1 : 0;
        angles.longest = std::max(angles.longest, shape.longestEdge);
    }
    return angles;
}

/// One line for each face.
void printFaces(const BrepModel& model, const SurfaceSample& sample)
{
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        const SampledFace* face = sample.surface->faces().face(BrepFaceId(f));
        if (face == nullptr) continue;
        const FaceRefinementCounts c = face->refiner.counts();
        std::cerr << nameOf(BrepFaceId(f)) << " kind "
                  << static_cast<int>(model.faces[BrepFaceId(f)].surface->kind()) << " triangles "
                  << face->mesh.triangleCount() << " size " << c.sizeInsertions << " quality "
                  << c.qualityInsertions << " boundary " << c.boundaryInsertions << " left "
                  << c.leftForResolution << " lost " << c.splits.lostWalks << " folded "
                  << c.splits.foldedStars << " edges " << c.splits.splitEdges << " projected "
                  << c.splits.projectedCentres << '\n';
    }
}

void writeOff(const SurfaceMesh& mesh, const std::string& path)
{
    std::ofstream out(path);
    std::size_t count = 0;
    for (const SurfaceFacet& facet : mesh.facets) count += facet.isAlive() ? 1 : 0;
    out.precision(17);
    out << "OFF\n" << mesh.nodes.size() << ' ' << count << " 0\n";
    for (const MeshNode& node : mesh.nodes) {
        out << node.position.x << ' ' << node.position.y << ' ' << node.position.z << '\n';
    }
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        out << "3 " << facet.node[0].value << ' ' << facet.node[1].value << ' ' << facet.node[2].value
            << '\n';
    }
}

}  // namespace

int main(int count, char** words)
{
    if (count < 2) {
        std::cerr << "sample_model FILE [--share S] [--size H] [--rho R] [--turn N] [--sag D] [--lens A] "
                     "[--threads N]\n";
        return 2;
    }
    double share = 0.0;
    bool isByFace = false;
    std::string off;
    SurfaceSamplingOptions options;
    options.limits.maxVertices = 2'000'000;
    RunSettings settings;
    for (int i = 2; i + 1 < count; i += 2) {
        const std::string_view name = words[i];
        const double value = std::strtod(words[i + 1], nullptr);
        if (name == "--share") share = value;
        if (name == "--size") options.facets.maxSize = value;
        if (name == "--rho") options.facets.rho = value;
        if (name == "--turn") options.facets.elementsPerTurn = value;
        if (name == "--sag") options.facets.maxSag = value;
        if (name == "--lens") options.encroachmentAngle = value;
        if (name == "--angle") options.facets.minAngle = value;
        if (name == "--threads") settings.threads = static_cast<unsigned>(value);
        if (name == "--certificate") options.maxCertificateRounds = static_cast<int>(value);
        if (name == "--deviation") options.facets.maxNormalDeviation = value;
        if (name == "--max") options.limits.maxVertices = static_cast<std::uint64_t>(value);
        if (name == "--faces") isByFace = value != 0.0;
        if (name == "--off") off = words[i + 1];
    }
    const auto read = readModel(words[1]);
    if (!read) {
        std::cerr << describe(read.error()) << '\n';
        return 1;
    }
    if (share > 0.0) options.facets.maxSize = share * length(read->model.box.extent());
    RunContext context(settings);
    const double start = cpuSeconds();
    const auto sample = sampleSurface(read->model, options, context);
    const double seconds = cpuSeconds() - start;
    if (!sample) {
        std::cerr << describe(sample.error()) << '\n';
        return 1;
    }
    const SurfaceMesh& mesh = sample->surface->mesh();
    if (!off.empty()) writeOff(mesh, off);
    if (isByFace) printFaces(read->model, *sample);
    const Angles angles = measure(mesh);
    const SurfaceCheck check = checkSurfaceMesh(read->model, mesh);
    const SurfaceSamplingCounts& c = sample->counts;
    std::cout << "{\"file\": \"" << words[1] << "\", \"faces\": " << read->model.faces.size()
              << ", \"stop\": \"" << nameOf(sample->stopReason)
              << "\", \"failures\": " << sample->failures.size() << ", \"vertices\": " << c.vertices
              << ", \"facets\": " << c.facets << ", \"segments\": " << c.segments
              << ", \"initial\": " << c.initialVertices << ", \"rounds\": " << c.rounds.rounds
              << ", \"splits\": " << c.rounds.segmentSplits << ", \"refused\": " << c.rounds.refusedSplits
              << ", \"min_angle\": " << angles.least << ", \"below30\": " << angles.below30
              << ", \"below20\": " << angles.below20 << ", \"longest\": " << angles.longest
              << ", \"left_small\": " << c.refinement.leftAtSmallAngles
              << ", \"left\": " << c.refinement.leftForResolution
              << ", \"removals\": " << c.refinement.removals << ", \"forced\": " << c.refinement.forcedStars
              << ", \"projected\": " << c.refinement.splits.projectedCentres
              << ", \"edges_split\": " << c.refinement.splits.splitEdges
              << ", \"lost\": " << c.refinement.splits.lostWalks
              << ", \"folded\": " << c.refinement.splits.foldedStars
              << ", \"steep\": " << c.refinement.splits.steepStars
              << ", \"crossing\": " << c.certificate.found << ", \"shared\": " << c.certificate.shared
              << ", \"crossing_left\": " << c.certificate.left
              << ", \"certificate_rounds\": " << c.certificate.rounds
              << ", \"cpu_certificate\": " << sample->seconds.certificate << ", \"cpu\": " << seconds
              << ", \"cpu_initial\": " << sample->seconds.curves + sample->seconds.initial
              << ", \"cpu_refine\": " << sample->seconds.refinement
              << ", \"per_second\": " << static_cast<double>(c.vertices) / seconds << ", \"check\": \""
              << check.problem() << "\"}\n";
    for (const Error& error : c.certificate.errors) std::cerr << describe(error) << '\n';
    for (const auto& [face, error] : sample->failures) std::cerr << describe(error) << '\n';
    return check.isValid() && sample->failures.empty() ? 0 : 3;
}
