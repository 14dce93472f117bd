#pragma once

#include <algorithm>
#include <cstdint>

namespace mesher {

/// Tells a refinement for quality that comes to an end from one that does not, by the bad elements that wait. Where the quality
/// asked for is in reach, their number falls by half and more while the vertices grow by half; where it is not, each vertex
/// makes as many bad elements as it removes, and the share of bad ones stays what it is however long the run goes on.
/// Guarantees   depends on what it is told alone, not on time
/// Cost         a count of the bad elements each time that the vertices have grown by a quarter
class BacklogWatch
{
public:
    /// Is it time to count the bad elements? For the first time at once.
    [[nodiscard]] bool isDue(std::uint64_t vertices) const { return vertices >= next_; }

    /// Takes the count, and returns whether the backlog has not become smaller over the last two of them.
    bool look(std::uint64_t vertices, std::uint64_t bad)
    {
        next_ = vertices + std::max(kLeastGrowth, vertices / 4);
        const bool isStuck = looks_ >= 2 && bad >= kFew && 5 * bad > 4 * beforeLast_;
        beforeLast_ = last_;
        last_ = bad;
        ++looks_;
        return isStuck;
    }

private:
    static constexpr std::uint64_t kLeastGrowth = 200;
    /// So few may come and go by chance.
    static constexpr std::uint64_t kFew = 20;

    std::uint64_t next_ = 0;
    std::uint64_t last_ = 0;
    std::uint64_t beforeLast_ = 0;
    std::uint64_t looks_ = 0;
};

}  // namespace mesher
