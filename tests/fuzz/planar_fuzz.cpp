// Meshes random planar domains and checks each. Options: --domains N, --seed S, --from I (resumes at a domain), --verbose 1.
// Domain I of seed S depends on nothing else. Ends with 1 if a domain failed; each failure is one line.

#include "base/random.h"
#include "base/run_context.h"
#include "sizing/shape_sizes.h"
#include "support/random_domains.h"
#include "triangulation2d/planar_check.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

namespace mesher::test {
namespace {

struct Options
{
    std::uint64_t domains = 500;
    std::uint64_t seed = 1;
    std::uint64_t from = 0;
    bool isVerbose = false;
};

std::optional<Options> parseOptions(int count, char** words)
{
    Options options;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string_view name = words[i];
        const std::uint64_t value = std::strtoull(words[i + 1], nullptr, 10);
        if (name == "--domains")
            options.domains = value;
        else if (name == "--seed")
            options.seed = value;
        else if (name == "--from")
            options.from = value;
        else if (name == "--verbose")
            options.isVerbose = value != 0;
        else
            return std::nullopt;
    }
    if (count % 2 == 0) return std::nullopt;
    return options;
}

/// Every domain also draws how it is meshed; `ball` is used by some.
PlanarOptions drawOptions(Random& random, const BallSize& ball)
{
    PlanarOptions options;
    if (random.below(4) == 0) options.refinement.sizing.field = &ball;
    if (random.below(6) == 0) options.refinement.minAngle = random.between(0.0, 32.0);
    options.limits.maxVertices = 400'000;
    options.limits.maxOperations = 4'000'000;
    if (random.below(3) == 0) options.sampling.maxVariation = random.between(30.0, 90.0);
    if (random.below(3) == 0) options.refinement.sizing.refinement = random.between(1.0, 3.0);
    if (random.below(3) == 0) options.refinement.sizing.grading = random.between(1.0, 4.0);
    if (random.below(4) == 0) options.refinement.sizing.usesLocalFeatureSize = false;
    return options;
}

/// [miller2003] proves it beside small angles between segments; refinement keeps it between curves.
constexpr double kLargestAngle = 137.0;

/// Over all domains of a run.
struct Tally
{
    std::uint64_t failures = 0;
    std::uint64_t triangles = 0;
    std::uint64_t leftTriangles = 0;  ///< beside small input angles
    double largestAngle = 0.0;        ///< with a bound of 30 degrees or more
};

/// What went wrong with a domain; nothing if all is well.
std::optional<std::string> failureOf(const RandomDomain& domain, const PlanarOptions& options,
                                     std::string& summary, Tally& tally)
{
    RunContext context;
    auto result = triangulatePlanar(domain.complex, options, context);
    if (!result) return "refused: " + describe(result.error());
    const PlanarCheck check = checkPlanar(domain.complex, *result, options);
    summary = std::to_string(result->counts.triangles) + " triangles, angles " +
              std::to_string(check.angles.smallest) + " to " + std::to_string(check.angles.largest);
    if (result->stopReason != StopReason::Done) {
        return "stopped: " + std::string(nameOf(result->stopReason)) + ", " + summary;
    }
    if (!check.isClean()) return check.violations.front() + ", " + summary;
    tally.triangles += result->counts.triangles;
    tally.leftTriangles += result->refinement.left.size();
    if (options.refinement.minAngle >= 30.0)
        tally.largestAngle = std::max(tally.largestAngle, check.angles.largest);
    if (options.refinement.minAngle >= 30.0 && check.angles.largest > kLargestAngle) {
        return "largest angle, " + summary;
    }
    return std::nullopt;
}

int run(const Options& options)
{
    Tally tally;
    for (std::uint64_t i = options.from; i < options.from + options.domains; ++i) {
        Random random(options.seed * 0x9E3779B97F4A7C15u + i);
        const RandomDomain domain = randomDomain(random());
        DistanceProfile profile;
        profile.size = random.between(0.01, 0.2);
        profile.growth = random.between(0.1, 2.0);
        const Vec3 centre{random.between(0.0, 2.0), random.between(0.0, 2.0), 0.0};
        const BallSize ball(centre, random.between(0.0, 0.5), profile);
        const PlanarOptions planar = drawOptions(random, ball);
        std::string summary;
        const auto start = std::chrono::steady_clock::now();
        const auto failure = failureOf(domain, planar, summary, tally);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (failure) ++tally.failures;
        if (failure || options.isVerbose) {
            std::cout << "domain " << i << " of seed " << options.seed << " [" << domain.description << "] R "
                      << planar.refinement.sizing.refinement << " G " << planar.refinement.sizing.grading
                      << " bound " << planar.refinement.minAngle << ": "
                      << (failure ? "FAILED " + *failure : summary) << " (" << seconds << " s)" << std::endl;
        }
    }
    std::cout << options.domains << " domains, " << tally.failures << " failures, " << tally.triangles
              << " triangles, " << tally.leftTriangles << " left beside small angles, largest angle "
              << tally.largestAngle << " at a bound of 30 degrees or more" << std::endl;
    return tally.failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace mesher::test

int main(int count, char** words)
{
    const auto options = mesher::test::parseOptions(count, words);
    if (!options) {
        std::cerr << "planar_fuzz [--domains N] [--seed S] [--from I] [--verbose 0|1]\n";
        return 2;
    }
    return mesher::test::run(*options);
}
