#include "property/noncrossing_segments.h"

#include "base/random.h"
#include "predicates/orient2d.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher::test {
namespace {

using Segment = std::pair<Vec2, Vec2>;

bool areDisjoint(const Segment& s, const Segment& t)
{
    const auto isSplit = [](const Segment& line, const Segment& other) {
        const Sign first = orient2d(line.first, line.second, other.first);
        return first * orient2d(line.first, line.second, other.second) != Sign::Positive;
    };
    return !isSplit(s, t) || !isSplit(t, s);
}

/// Accepted segments by the cells of a grid that they pass.
class SegmentGrid
{
public:
    SegmentGrid() : cells_(kCells * kCells) {}

    [[nodiscard]] bool accepts(const Segment& candidate)
    {
        bool isFree = true;
        forEachCell(candidate, [&](std::vector<std::uint32_t>& cell) {
            isFree = isFree && std::all_of(cell.begin(), cell.end(), [&](std::uint32_t i) {
                         return areDisjoint(candidate, segments_[i]);
                     });
        });
        return isFree;
    }

    void add(const Segment& segment)
    {
        const auto index = static_cast<std::uint32_t>(segments_.size());
        segments_.push_back(segment);
        forEachCell(segment, [index](std::vector<std::uint32_t>& cell) { cell.push_back(index); });
    }

    [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

private:
    static constexpr std::size_t kCells = 700;

    static std::size_t cellOf(double coordinate)
    {
        return std::min(kCells - 1, static_cast<std::size_t>(std::max(0.0, coordinate * kCells)));
    }

    /// Row by row the cells between the points where the segment enters and leaves the row, and one more on each side
    /// for the rounding of these points.
    template <class Visit>
    void forEachCell(const Segment& segment, Visit&& visit)
    {
        auto [low, high] = segment;
        if (low.y > high.y) std::swap(low, high);
        for (std::size_t row = cellOf(low.y); row <= cellOf(high.y); ++row) {
            const auto at = [&](double y) {
                const double t = high.y > low.y ? std::clamp((y - low.y) / (high.y - low.y), 0.0, 1.0) : 0.0;
                return low.x + t * (high.x - low.x);
            };
            const double enter = high.y > low.y ? at(static_cast<double>(row) / kCells) : low.x;
            const double leave = high.y > low.y ? at(static_cast<double>(row + 1) / kCells) : high.x;
            const std::size_t first = cellOf(std::min(enter, leave));
            const std::size_t last = cellOf(std::max(enter, leave));
            for (std::size_t column = first == 0 ? 0 : first - 1; column <= std::min(kCells - 1, last + 1);
                 ++column) {
                visit(cells_[row * kCells + column]);
            }
        }
    }

    std::vector<Segment> segments_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

std::vector<std::pair<Vec2, Vec2>> nonCrossingSegments(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    SegmentGrid grid;
    while (grid.segments().size() < count) {
        const Vec2 middle{random.unit(), random.unit()};
        const double half = 0.25 * std::exp2(-11.0 * random.unit());
        const double angle = random.between(0.0, std::numbers::pi);
        const Vec2 reach{half * std::cos(angle), half * std::sin(angle)};
        const Segment candidate{middle - reach, middle + reach};
        const auto isInside = [](Vec2 p) { return 0.0 <= p.x && p.x < 1.0 && 0.0 <= p.y && p.y < 1.0; };
        if (!isInside(candidate.first) || !isInside(candidate.second)) continue;
        if (grid.accepts(candidate)) grid.add(candidate);
    }
    return grid.segments();
}

}  // namespace mesher::test
