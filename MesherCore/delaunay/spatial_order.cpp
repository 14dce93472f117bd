#include "delaunay/spatial_order.h"

#include "base/box.h"
#include "base/random.h"
#include "delaunay/hilbert_curve.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace mesher {
namespace {

constexpr std::size_t kSmallestRound = 1000;
constexpr unsigned kLogRoundGrowth = 3;

/// A coordinate on a grid as a cell number; what is not a number falls into cell 0.
std::uint32_t cellNumber(double gridCoordinate, double lastCell)
{
    return gridCoordinate > 0.0 ? static_cast<std::uint32_t>(std::min(gridCoordinate, lastCell)) : 0u;
}

/// The grids over the bounding square or cube in whose cells points are sorted: a coarse one whose keys are
/// packed beside an index, and a deep one for points that share a coarse cell.
template <class Point>
struct CellGrid;

template <>
struct CellGrid<Vec2>
{
    using Curve = HilbertCurve<2>;
    static constexpr unsigned kCoarseLevels = 16;
    static constexpr unsigned kDeepLevels = 32;

    explicit CellGrid(std::span<const Vec2> points) : box(Box2::of(points)), extent(largest(box.extent())) {}

    [[nodiscard]] Curve::Cell cellOf(Vec2 p, double scale, double lastCell) const
    {
        return {cellNumber((p.x - box.low.x) * scale, lastCell),
                cellNumber((p.y - box.low.y) * scale, lastCell)};
    }

    Box2 box;
    double extent;

private:
    static double largest(Vec2 v) { return std::max(v.x, v.y); }
};

template <>
struct CellGrid<Vec3>
{
    using Curve = HilbertCurve<3>;
    static constexpr unsigned kCoarseLevels = 10;
    static constexpr unsigned kDeepLevels = 20;

    explicit CellGrid(std::span<const Vec3> points) : box(Box3::of(points)), extent(largest(box.extent())) {}

    [[nodiscard]] Curve::Cell cellOf(Vec3 p, double scale, double lastCell) const
    {
        return {cellNumber((p.x - box.low.x) * scale, lastCell),
                cellNumber((p.y - box.low.y) * scale, lastCell),
                cellNumber((p.z - box.low.z) * scale, lastCell)};
    }

    Box3 box;
    double extent;

private:
    static double largest(Vec3 v) { return std::max({v.x, v.y, v.z}); }
};

/// A key of 32 bits over the index of the point it belongs to.
using PackedKey = std::uint64_t;

constexpr std::uint32_t indexOf(PackedKey packed) { return static_cast<std::uint32_t>(packed); }
constexpr std::uint32_t keyOf(PackedKey packed) { return static_cast<std::uint32_t>(packed >> 32); }

/// Sorts by key, stable; three passes of 11 bits, least significant first.
void radixSort(std::span<PackedKey> keys, std::span<PackedKey> scratch)
{
    constexpr unsigned kDigitBits = 11;
    constexpr std::size_t kBuckets = std::size_t{1} << kDigitBits;
    constexpr unsigned kPasses = 3;
    std::uint32_t starts[kPasses][kBuckets] = {};
    for (const PackedKey key : keys) {
        for (unsigned pass = 0; pass < kPasses; ++pass) {
            ++starts[pass][key >> (32 + pass * kDigitBits) & (kBuckets - 1)];
        }
    }
    std::span<PackedKey> from = keys;
    std::span<PackedKey> to = scratch;
    for (unsigned pass = 0; pass < kPasses; ++pass) {
        std::uint32_t sum = 0;
        for (std::uint32_t& start : starts[pass]) start = std::exchange(sum, sum + start);
        for (const PackedKey key : from) {
            to[starts[pass][key >> (32 + pass * kDigitBits) & (kBuckets - 1)]++] = key;
        }
        std::swap(from, to);
    }
    std::copy(from.begin(), from.end(), keys.begin());
}

/// Orders points that share the cell of the coarse sort by the full depth of the curve.
template <class Point>
void sortDeep(std::span<const Point> points, const CellGrid<Point>& grid, std::span<PackedKey> run)
{
    using Grid = CellGrid<Point>;
    constexpr double kCells = static_cast<double>(std::uint64_t{1} << Grid::kDeepLevels);
    std::vector<std::pair<std::uint64_t, PackedKey>> deep;
    deep.reserve(run.size());
    for (const PackedKey packed : run) {
        const auto cell = grid.cellOf(points[indexOf(packed)], kCells / grid.extent, kCells - 1.0);
        deep.emplace_back(Grid::Curve::key(cell, Grid::kDeepLevels), packed);
    }
    std::sort(deep.begin(), deep.end());
    for (std::size_t i = 0; i < run.size(); ++i) run[i] = deep[i].second;
}

/// Sorts the points whose indices are the lower halves of `keys` along the curve.
template <class Point>
void sortAlongCurve(std::span<const Point> points, const CellGrid<Point>& grid, std::span<PackedKey> keys,
                    std::span<PackedKey> scratch)
{
    using Grid = CellGrid<Point>;
    constexpr double kCells = static_cast<double>(1u << Grid::kCoarseLevels);
    const double scale = kCells / grid.extent;
    for (PackedKey& packed : keys) {
        const auto cell = grid.cellOf(points[indexOf(packed)], scale, kCells - 1.0);
        packed = Grid::Curve::key(cell, Grid::kCoarseLevels) << 32 | indexOf(packed);
    }
    radixSort(keys, scratch);
    for (std::size_t first = 0; first < keys.size();) {
        std::size_t last = first + 1;
        while (last < keys.size() && keyOf(keys[last]) == keyOf(keys[first])) ++last;
        if (last - first > 1) sortDeep(points, grid, keys.subspan(first, last - first));
        first = last;
    }
}

/// Number of the round of a point, counted from the last (largest) one: each holds an eighth of its successor.
unsigned roundFromLast(std::uint64_t seed, std::uint32_t index, unsigned roundCount)
{
    const std::uint64_t bits = Random(seed + index * 0xD1342543DE82EF95u)();
    const auto zeros = static_cast<unsigned>(std::countl_zero(bits)) / kLogRoundGrowth;
    return std::min(zeros, roundCount - 1);
}

template <class Point>
std::vector<std::uint32_t> orderInRounds(std::span<const Point> points, unsigned roundCount,
                                         std::uint64_t seed)
{
    const auto count = static_cast<std::uint32_t>(points.size());
    std::vector<std::uint32_t> starts(roundCount + 1, 0);
    std::vector<std::uint8_t> rounds(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const unsigned round = roundCount - 1 - roundFromLast(seed, i, roundCount);
        rounds[i] = static_cast<std::uint8_t>(round);
        ++starts[round + 1];
    }
    for (unsigned round = 0; round < roundCount; ++round) starts[round + 1] += starts[round];

    std::vector<PackedKey> keys(count);
    std::vector<std::uint32_t> next = starts;
    for (std::uint32_t i = 0; i < count; ++i) keys[next[rounds[i]]++] = i;

    const CellGrid<Point> grid(points);
    std::vector<PackedKey> scratch(count);
    for (unsigned round = 0; round < roundCount; ++round) {
        const std::span<PackedKey> part(keys.data() + starts[round], starts[round + 1] - starts[round]);
        sortAlongCurve(points, grid, part, std::span(scratch).first(part.size()));
    }
    std::vector<std::uint32_t> order(count);
    std::transform(keys.begin(), keys.end(), order.begin(), indexOf);
    return order;
}

unsigned roundCountFor(std::size_t pointCount)
{
    unsigned rounds = 1;
    for (std::size_t smallest = pointCount >> kLogRoundGrowth; smallest >= kSmallestRound;
         smallest >>= kLogRoundGrowth) {
        ++rounds;
    }
    return rounds;
}

}  // namespace

std::vector<std::uint32_t> hilbertOrder(std::span<const Vec2> points) { return orderInRounds(points, 1, 0); }
std::vector<std::uint32_t> hilbertOrder(std::span<const Vec3> points) { return orderInRounds(points, 1, 0); }

std::vector<std::uint32_t> brioOrder(std::span<const Vec2> points, std::uint64_t seed)
{
    return orderInRounds(points, roundCountFor(points.size()), seed);
}
std::vector<std::uint32_t> brioOrder(std::span<const Vec3> points, std::uint64_t seed)
{
    return orderInRounds(points, roundCountFor(points.size()), seed);
}

}  // namespace mesher
