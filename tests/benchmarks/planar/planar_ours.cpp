// Times the mesher, or writes a domain as the polylines that peers take. One line of JSON.
//     planar_ours mesh square|annulus|airfoil SIZE|0 DEGREES       DEGREES: total variation of a subcurve; 0: quality alone
//     planar_ours outline square|annulus|airfoil DEGREES FILE      lines "v X Y", "e I J" between vertices, "s X Y" in holes

#include "base/run_context.h"
#include "delaunay/mesh_hash2d.h"
#include "sizing/uniform_size.h"
#include "support/planar_examples.h"
#include "triangulation2d/planar_check.h"
#include "triangulation2d/triangulate_planar.h"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace mesher {
namespace {

struct Domain
{
    PlanarCurveComplex complex;
    std::vector<Vec2> inHoles;  ///< a point inside of each hole
};

Domain domainNamed(const std::string& name)
{
    if (name == "square") return {test::unitSquare(), {}};
    if (name == "annulus") return {test::annulus(), {{0.0, 0.0}}};
    // A tenth of the chord behind the nose of slat, main element and flap.
    return {test::threeElementAirfoil(), {{-0.1406, -0.081}, {0.11, 0.0}, {0.887, -0.0905}}};
}

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Largest resident size of this process so far, bytes.
double peakMemory()
{
    // Not getrusage: its maximum is inherited from the process that started this one.
    std::ifstream status("/proc/self/status");
    std::string word;
    double kibibytes = 0.0;
    while (status >> word) {
        if (word == "VmHWM:" && status >> kibibytes) break;
    }
    return 1024.0 * kibibytes;
}

int mesh(const Domain& domain, double size, double degrees)
{
    const UniformSize uniform(size > 0.0 ? size : 1.0);
    PlanarOptions options;
    options.sampling.maxVariation = degrees;
    options.refinement.sizing.usesLocalFeatureSize = size > 0.0;
    if (size > 0.0) options.refinement.sizing.field = &uniform;
    RunContext context;
    const double memoryBefore = peakMemory();
    const double start = cpuSeconds();
    const auto result = triangulatePlanar(domain.complex, options, context);
    const double seconds = cpuSeconds() - start;
    if (!result) {
        std::cerr << describe(result.error()) << '\n';
        return 1;
    }
    const double memory = peakMemory() - memoryBefore;
    const PlanarTimes& s = result->seconds;
    const double stages = s.sampling + s.enrichment + s.initialTriangulation + s.refinement;
    const auto triangles = static_cast<double>(result->counts.triangles);
    const AngleStatistics angles = checkPlanar(domain.complex, *result, options).angles;
    std::cout << "{\"triangles\": " << result->counts.triangles
              << ", \"vertices\": " << result->counts.vertices << ", \"cpu_seconds\": " << seconds
              << ", \"enrichment_share\": " << (s.sampling + s.enrichment) / stages
              << ", \"mesh_bytes_per_triangle\": "
              << static_cast<double>(result->triangulation.mesh().bytes()) / triangles
              << ", \"peak_bytes_per_triangle\": " << memory / triangles
              << ", \"min_angle\": " << angles.smallest << ", \"max_angle\": " << angles.largest
              << ", \"hash\": \"" << std::hex << meshHash2d(result->triangulation.mesh()) << "\"}\n";
    return 0;
}

int writeOutline(const Domain& domain, double degrees, const std::string& path)
{
    const auto planar = PlanarDomain::make(domain.complex);
    CurveSamplingOptions sampling;
    sampling.maxVariation = degrees;
    const auto boundary = sampleCurves(*planar, sampling);
    if (!boundary) {
        std::cerr << describe(boundary.error()) << '\n';
        return 1;
    }
    std::ofstream file(path);
    file.precision(std::numeric_limits<double>::max_digits10);
    for (const BoundaryVertex& v : boundary->vertices) file << "v " << v.space.x << ' ' << v.space.y << '\n';
    for (const Subcurve& s : boundary->subcurves) {
        if (s.isAlive) file << "e " << s.first.value << ' ' << s.last.value << '\n';
    }
    for (const Vec2 p : domain.inHoles) file << "s " << p.x << ' ' << p.y << '\n';
    std::cout << "{\"segments\": " << boundary->aliveCount() << "}\n";
    return file.good() ? 0 : 1;
}

}  // namespace
}  // namespace mesher

int main(int count, char** words)
{
    const std::string command = count > 1 ? words[1] : "";
    if (count != 5 || (command != "mesh" && command != "outline")) {
        std::cerr << "planar_ours mesh square|annulus|airfoil SIZE|0 DEGREES\n"
                     "planar_ours outline square|annulus|airfoil DEGREES FILE\n";
        return 2;
    }
    const mesher::Domain domain = mesher::domainNamed(words[2]);
    const double number = std::strtod(words[3], nullptr);
    return command == "mesh" ? mesher::mesh(domain, number, std::strtod(words[4], nullptr))
                             : mesher::writeOutline(domain, number, words[4]);
}
