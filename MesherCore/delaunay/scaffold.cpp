#include "delaunay/scaffold.h"

#include "base/box.h"
#include "base/random.h"
#include "predicates/coordinate_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace mesher {

namespace {

/// Spreads the low 21 bits to every third bit.
std::uint64_t spreadBits(std::uint64_t x)
{
    x &= 0x1FFFFF;
    x = (x | x << 32) & 0x1F00000000FFFF;
    x = (x | x << 16) & 0x1F0000FF0000FF;
    x = (x | x << 8) & 0x100F00F00F00F00F;
    x = (x | x << 4) & 0x10C30C30C30C30C3;
    return (x | x << 2) & 0x1249249249249249;
}

/// The cube around the points and its cells of the finest level.
class MortonGrid
{
public:
    static constexpr std::uint32_t kLevels = 21;

    explicit MortonGrid(std::span<const Vec3> points)
    {
        const Box3 box = Box3::of(points);
        const Vec3 extent = box.extent();
        // A little room around, so that no point is on the upper sides.
        edge_ = 1.0625 * std::max({extent.x, extent.y, extent.z, kSmallestEdge});
        const Vec3 centre = 0.5 * (box.low + box.high);
        low_ = centre - 0.5 * Vec3{edge_, edge_, edge_};
    }

    [[nodiscard]] std::uint64_t code(const Vec3& p) const
    {
        const Vec3 unit = (kCells / edge_) * (p - low_);
        return spreadBits(clamped(unit.x)) << 2 | spreadBits(clamped(unit.y)) << 1 |
               spreadBits(clamped(unit.z));
    }
    /// About the centre of a cell with the given corner, in cells of its level; `jitter` as in ScaffoldOptions.
    [[nodiscard]] Vec3 nearCentre(const std::array<std::uint32_t, 3>& cell, std::uint32_t level,
                                  double jitter) const
    {
        const double size = edge_ / static_cast<double>(1u << level);
        Random random((std::uint64_t{cell[0]} << 42 | std::uint64_t{cell[1]} << 21 | cell[2]) ^
                      std::uint64_t{level} << 59);
        const auto offset = [&] { return random.between(0.5 - jitter, 0.5 + jitter); };
        const double x = cell[0] + offset();
        const double y = cell[1] + offset();
        const double z = cell[2] + offset();
        return low_ + size * Vec3{x, y, z};
    }

private:
    static constexpr double kCells = 1u << kLevels;
    static constexpr double kSmallestEdge = 1e-300;

    static std::uint64_t clamped(double x)
    {
        return static_cast<std::uint64_t>(std::clamp(x, 0.0, kCells - 1.0));
    }

    Vec3 low_;
    double edge_ = 0.0;
};

std::vector<std::uint64_t> sortedCodes(std::span<const Vec3> points, const MortonGrid& grid)
{
    std::vector<std::uint64_t> codes(points.size());
    std::transform(points.begin(), points.end(), codes.begin(), [&](const Vec3& p) { return grid.code(p); });
    std::sort(codes.begin(), codes.end());
    return codes;
}

/// An octree over sorted Morton codes, refined where points are and graded.
class GradedOctree
{
public:
    struct Cell
    {
        std::array<std::uint32_t, 3> corner{};  ///< in cells of its level
        std::uint32_t level = 0;
        std::uint32_t begin = 0;  ///< range of the codes inside
        std::uint32_t end = 0;
        std::uint32_t firstChild = 0;  ///< 0: a leaf
    };

    GradedOctree(std::span<const std::uint64_t> codes, const ScaffoldOptions& options) : codes_(codes)
    {
        Cell root;
        root.end = static_cast<std::uint32_t>(codes.size());
        cells_.push_back(root);
        for (std::uint32_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i].end - cells_[i].begin > options.pointsPerCell &&
                cells_[i].level < options.maxLevel) {
                split(i);
            }
        }
        grade();
    }

    [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }

private:
    void split(std::uint32_t index)
    {
        const Cell parent = cells_[index];
        cells_[index].firstChild = static_cast<std::uint32_t>(cells_.size());
        const std::uint32_t shift = 3 * (MortonGrid::kLevels - parent.level - 1);
        std::uint32_t begin = parent.begin;
        for (std::uint32_t child = 0; child < 8; ++child) {
            Cell cell;
            cell.level = parent.level + 1;
            cell.corner = {parent.corner[0] * 2 + (child >> 2 & 1), parent.corner[1] * 2 + (child >> 1 & 1),
                           parent.corner[2] * 2 + (child & 1)};
            cell.begin = begin;
            const auto last =
                std::partition_point(codes_.begin() + begin, codes_.begin() + parent.end,
                                     [&](std::uint64_t code) { return (code >> shift & 7) <= child; });
            cell.end = begin = static_cast<std::uint32_t>(last - codes_.begin());
            cells_.push_back(cell);
        }
    }

    /// The leaf, at most as fine as `level`, that covers a cell of that level.
    [[nodiscard]] std::uint32_t leafAt(const std::array<std::uint32_t, 3>& corner, std::uint32_t level) const
    {
        std::uint32_t index = 0;
        while (cells_[index].firstChild != 0 && cells_[index].level < level) {
            const std::uint32_t shift = level - cells_[index].level - 1;
            index = cells_[index].firstChild + ((corner[0] >> shift & 1) << 2 |
                                                (corner[1] >> shift & 1) << 1 | (corner[2] >> shift & 1));
        }
        return index;
    }

    /// Splits leaves until those that share a face differ by one level at most. New cells are appended, so the loop
    /// reaches them too.
    void grade()
    {
        for (std::uint32_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i].firstChild != 0 || cells_[i].level < 2) continue;
            for (unsigned side = 0; side < 6; ++side) refineNeighbour(cells_[i], side);
        }
    }

    void refineNeighbour(const Cell cell, unsigned side)
    {
        std::array<std::uint32_t, 3> corner = cell.corner;
        std::uint32_t& coordinate = corner[side / 2];
        if (side % 2 == 0 ? coordinate == 0 : coordinate + 1 == 1u << cell.level) return;
        coordinate += side % 2 == 0 ? ~0u : 1u;
        for (;;) {
            const std::uint32_t leaf = leafAt(corner, cell.level);
            if (cells_[leaf].level + 1 >= cell.level) return;
            split(leaf);
        }
    }

    std::span<const std::uint64_t> codes_;
    std::vector<Cell> cells_;
};

}  // namespace

std::vector<Vec3> scaffoldPoints(std::span<const Vec3> points, const ScaffoldOptions& options)
{
    std::vector<Vec3> scaffold;
    if (points.empty()) return scaffold;
    const MortonGrid grid(points);
    const std::vector<std::uint64_t> codes = sortedCodes(points, grid);
    const GradedOctree octree(codes, options);
    for (const GradedOctree::Cell& cell : octree.cells()) {
        if (cell.firstChild != 0 || cell.begin != cell.end) continue;
        const Vec3 place = grid.nearCentre(cell.corner, cell.level, options.jitter);
        if (isInExactRange(place)) scaffold.push_back(place);
    }
    return scaffold;
}

bool isSurfaceLike(std::span<const Vec3> points)
{
    constexpr std::size_t kFewest = 1000;
    if (points.size() < kFewest) return false;
    const MortonGrid grid(points);
    const std::vector<std::uint64_t> codes = sortedCodes(points, grid);
    const auto occupied = [&](std::uint32_t level) {
        const std::uint32_t shift = 3 * (MortonGrid::kLevels - level);
        std::size_t count = 1;
        for (std::size_t i = 1; i < codes.size(); ++i)
            count += codes[i] >> shift != codes[i - 1] >> shift ? 1u : 0u;
        return count;
    };
    // The finest level at which an occupied cell still has 8 points on average, so that chance leaves few empty.
    std::uint32_t level = 1;
    while (level + 1 < MortonGrid::kLevels && occupied(level + 1) * 8 <= points.size()) ++level;
    if (level < 2) return false;
    const double growth = static_cast<double>(occupied(level)) / static_cast<double>(occupied(level - 1));
    return growth < std::pow(2.0, 2.5);
}

}  // namespace mesher
