// Speed of the four predicates beside CGAL's Epick kernel on the same points, in one program so that the
// ratios do not depend on the load of the machine.

#include "base/box.h"
#include "base/random.h"
#include "predicates/incircle.h"
#include "predicates/insphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using mesher::Random;
using mesher::Sign;
using mesher::Vec2;
using mesher::Vec3;

/// Enough calls to defeat the branch predictor's memory, few enough to stay in the second-level cache.
constexpr std::size_t kCalls = 2048;
constexpr double kClusterSize = 0.01;

enum class Data
{
    Uniform,        ///< independent points of the unit box
    Cluster,        ///< points as near to each other as those of a triangulation of a million points
    Grid,           ///< corners of cells of a binary grid: cospherical and coplanar, short coordinates
    DecimalGrid,    ///< the same on multiples of 0.1, whose coordinates are rounded
    NearDegenerate  ///< points on one sphere, or in one oblique plane, rounded to doubles
};

using Points3 = std::array<Vec3, 5>;
using Points2 = std::array<Vec2, 4>;

Vec3 uniformPoint(Random& random) { return {random.unit(), random.unit(), random.unit()}; }

Vec3 directionOf(Random& random)
{
    for (;;) {
        const Vec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const double size = length(p);
        if (size > 0.1 && size < 1.0) return (1.0 / size) * p;
    }
}

Points3 cellCorners(Random& random, double step)
{
    const Vec3 low{double(random.below(60)), double(random.below(60)), double(random.below(60))};
    Points3 points;
    const std::uint32_t mask = random.below(8);
    const std::array<std::uint32_t, 5> corners{0, 1, 2, 4, 7};
    for (std::size_t i = 0; i < 5; ++i) {
        const std::uint32_t corner = corners[i] ^ mask;
        points[i] = {(low.x + (corner & 1)) * step, (low.y + ((corner >> 1) & 1)) * step,
                     (low.z + ((corner >> 2) & 1)) * step};
    }
    return points;
}

Points3 makePoints3(Random& random, Data data)
{
    Points3 points;
    const Vec3 centre = uniformPoint(random);
    for (Vec3& p : points) {
        if (data == Data::Uniform) p = uniformPoint(random);
        if (data == Data::Cluster) p = centre + kClusterSize * (uniformPoint(random) - Vec3{0.5, 0.5, 0.5});
        if (data == Data::NearDegenerate) p = Vec3{3.0, 4.0, 5.0} + 0.75 * directionOf(random);
    }
    if (data == Data::Grid) return cellCorners(random, 1.0 / 64);
    if (data == Data::DecimalGrid) return cellCorners(random, 0.1);
    return points;
}

/// For orient3d: the degenerate sets must be coplanar.
Points3 makePlanarPoints3(Random& random, Data data)
{
    Points3 points = makePoints3(random, data);
    if (data == Data::Grid || data == Data::DecimalGrid) points[3] = {points[1].x, points[2].y, points[0].z};
    if (data == Data::NearDegenerate) {
        const double s = random.unit();
        const double t = random.unit();
        points[3] = points[0] + s * (points[1] - points[0]) + t * (points[2] - points[0]);
    }
    return points;
}

Points2 makePoints2(Random& random, Data data)
{
    const Points3 points = makePoints3(random, data);
    Points2 flat;
    for (std::size_t i = 0; i < 4; ++i) flat[i] = {points[i].x, points[i].y};
    if (data == Data::Grid || data == Data::DecimalGrid) flat[3] = {points[1].x, points[2].y};
    if (data == Data::NearDegenerate) {
        for (Vec2& p : flat) {
            const double angle = random.between(0, 6.28);
            p = {3.0 + 0.75 * std::cos(angle), 4.0 + 0.75 * std::sin(angle)};
        }
    }
    return flat;
}

Points2 makeLinearPoints2(Random& random, Data data)
{
    Points2 points = makePoints2(random, data);
    if (data == Data::Grid || data == Data::DecimalGrid) points[2] = {points[0].x, points[0].y + 3 * 0.125};
    if (data == Data::Grid || data == Data::DecimalGrid) points[1].x = points[0].x;
    if (data == Data::NearDegenerate) points[2] = points[0] + random.unit() * (points[1] - points[0]);
    return points;
}

template <class Set, class Make>
std::vector<Set> makeSets(Make make, Data data)
{
    Random random(20);
    std::vector<Set> sets;
    for (std::size_t i = 0; i < kCalls; ++i) sets.push_back(make(random, data));
    return sets;
}

std::array<Epick::Point_3, 5> toEpick(const Points3& p)
{
    std::array<Epick::Point_3, 5> points;
    for (std::size_t i = 0; i < 5; ++i) points[i] = {p[i].x, p[i].y, p[i].z};
    return points;
}
std::array<Epick::Point_2, 4> toEpick(const Points2& p)
{
    std::array<Epick::Point_2, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = {p[i].x, p[i].y};
    return points;
}

/// The filter of the box of all points, as the kernel makes it for the whole model.
mesher::StaticFilter3d filterOf(const std::vector<Points3>& sets)
{
    mesher::Box3 box;
    for (const Points3& set : sets) {
        for (const Vec3& p : set) box.include(p);
    }
    return mesher::StaticFilter3d::forBox(box);
}
mesher::StaticFilter2d filterOf(const std::vector<Points2>& sets)
{
    mesher::Box2 box;
    for (const Points2& set : sets) {
        for (const Vec2& p : set) box.include(p);
    }
    return mesher::StaticFilter2d::forBox(box);
}

template <class Sets, class Predicate>
void run(benchmark::State& state, const Sets& sets, Predicate predicate)
{
    for (auto _ : state) {
        int sum = 0;
        for (const auto& set : sets) sum += static_cast<int>(predicate(set)) > 0 ? 1 : 0;
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sets.size()));
}

template <class Set, class Make, class Plain, class Filtered, class Peer>
void registerFor(const std::string& predicate, Make make, Plain plain, Filtered filtered, Peer peer)
{
    const std::vector<std::pair<std::string, Data>> kinds{{"uniform", Data::Uniform},
                                                          {"cluster", Data::Cluster},
                                                          {"grid", Data::Grid},
                                                          {"decimal", Data::DecimalGrid},
                                                          {"near", Data::NearDegenerate}};
    for (const auto& [kind, data] : kinds) {
        const auto sets = makeSets<Set>(make, data);
        std::vector<decltype(toEpick(sets.front()))> peerSets;
        for (const Set& set : sets) peerSets.push_back(toEpick(set));
        const std::string name = predicate + "/" + kind + "/";
        benchmark::RegisterBenchmark((name + "ours").c_str(),
                                     [=](benchmark::State& s) { run(s, sets, plain); });
        benchmark::RegisterBenchmark((name + "filter").c_str(),
                                     [=, filter = filterOf(sets)](benchmark::State& s) {
                                         run(s, sets, [&](const Set& set) { return filtered(filter, set); });
                                     });
        benchmark::RegisterBenchmark((name + "epick").c_str(),
                                     [=](benchmark::State& s) { run(s, peerSets, peer); });
    }
}

void registerAll()
{
    registerFor<Points3>(
        "orient3d", makePlanarPoints3,
        [](const Points3& p) { return mesher::orient3d(p[0], p[1], p[2], p[3]); },
        [](const auto& filter, const Points3& p) { return mesher::orient3d(filter, p[0], p[1], p[2], p[3]); },
        [](const auto& p) { return Epick().orientation_3_object()(p[0], p[1], p[2], p[3]); });
    registerFor<Points3>(
        "insphere", makePoints3,
        [](const Points3& p) { return mesher::insphere(p[0], p[1], p[2], p[3], p[4]); },
        [](const auto& filter, const Points3& p) {
            return mesher::insphere(filter, p[0], p[1], p[2], p[3], p[4]);
        },
        [](const auto& p) {
            return Epick().side_of_oriented_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]);
        });
    registerFor<Points2>(
        "orient2d", makeLinearPoints2, [](const Points2& p) { return mesher::orient2d(p[0], p[1], p[2]); },
        [](const auto& filter, const Points2& p) { return mesher::orient2d(filter, p[0], p[1], p[2]); },
        [](const auto& p) { return Epick().orientation_2_object()(p[0], p[1], p[2]); });
    registerFor<Points2>(
        "incircle", makePoints2, [](const Points2& p) { return mesher::incircle(p[0], p[1], p[2], p[3]); },
        [](const auto& filter, const Points2& p) { return mesher::incircle(filter, p[0], p[1], p[2], p[3]); },
        [](const auto& p) { return Epick().side_of_oriented_circle_2_object()(p[0], p[1], p[2], p[3]); });
}

}  // namespace

int main(int argc, char** argv)
{
    registerAll();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
