// Speed of the Delaunay kernels by operation; items are points, so that "items_per_second" compares across sizes.

#include "base/random.h"
#include "base/run_context.h"
#include "delaunay/delaunay2d.h"
#include "delaunay/delaunay3d.h"
#include "delaunay/spatial_order.h"
#include "support/degenerate_points.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <span>
#include <vector>

namespace mesher {
namespace {

constexpr std::uint64_t kSeed = 7;

using Generator3d = std::vector<Vec3> (*)(std::size_t, std::uint64_t);

void countPoints(benchmark::State& state, std::size_t points)
{
    state.SetItemsProcessed(static_cast<std::int64_t>(points) *
                            static_cast<std::int64_t>(state.iterations()));
}

void bulkInsertion3d(benchmark::State& state, Generator3d generate, ScaffoldPolicy scaffold)
{
    const std::vector<Vec3> points = generate(static_cast<std::size_t>(state.range(0)), kSeed);
    for (auto _ : state) {
        Delaunay3d delaunay;
        RunContext context;
        const auto inserted =
            delaunay.insertPoints(points, {.classification = {}, .scaffold = scaffold}, context);
        benchmark::DoNotOptimize(inserted.hasValue());
    }
    countPoints(state, points.size());
}

/// One by one along the curve with the last tetrahedron as hint, as refinement inserts.
void singleInsertion3d(benchmark::State& state)
{
    const std::vector<Vec3> points = test::uniformPoints3d(static_cast<std::size_t>(state.range(0)), kSeed);
    const std::vector<std::uint32_t> order = brioOrder(std::span<const Vec3>(points), kSeed);
    for (auto _ : state) {
        Delaunay3d delaunay;
        TetId hint;
        for (const std::uint32_t index : order) hint = delaunay.insert(points[index], hint)->tet;
        benchmark::DoNotOptimize(hint);
    }
    countPoints(state, points.size());
}

void removal3d(benchmark::State& state)
{
    const std::vector<Vec3> points = test::uniformPoints3d(static_cast<std::size_t>(state.range(0)), kSeed);
    const std::size_t removed = points.size() / 4;
    for (auto _ : state) {
        state.PauseTiming();
        Delaunay3d delaunay;
        RunContext context;
        const auto inserted = delaunay.insertPoints(points, {}, context);
        state.ResumeTiming();
        for (std::size_t i = 0; i < removed; ++i)
            benchmark::DoNotOptimize(delaunay.remove(inserted->vertex[i]));
    }
    countPoints(state, removed);
}

void bulkInsertion2d(benchmark::State& state)
{
    const std::vector<Vec2> points = test::uniformPoints2d(static_cast<std::size_t>(state.range(0)), kSeed);
    for (auto _ : state) {
        Delaunay2d delaunay;
        RunContext context;
        const auto inserted = delaunay.insertPoints(points, &context);
        benchmark::DoNotOptimize(inserted.hasValue());
    }
    countPoints(state, points.size());
}

BENCHMARK_CAPTURE(bulkInsertion3d, uniform, test::uniformPoints3d, ScaffoldPolicy::None)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bulkInsertion3d, torus, test::torusPoints3d, ScaffoldPolicy::Always)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bulkInsertion3d, torus_without_scaffold, test::torusPoints3d, ScaffoldPolicy::None)
    ->Arg(100'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(singleInsertion3d)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(removal3d)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(bulkInsertion2d)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mesher

BENCHMARK_MAIN();
