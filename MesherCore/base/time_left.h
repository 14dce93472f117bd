#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace mesher {

/// A limit of time that several loops share: each is given what the ones before it have left.
class TimeLeft
{
public:
    using Clock = std::chrono::steady_clock;

    explicit TimeLeft(std::optional<Clock::duration> limit) : limit_(limit) {}

    /// Nothing if there is no limit, zero when it is over.
    [[nodiscard]] std::optional<Clock::duration> now() const
    {
        if (!limit_) return std::nullopt;
        return std::max(Clock::duration::zero(), *limit_ - (Clock::now() - start_));
    }
    [[nodiscard]] bool isOver() const { return limit_ && Clock::now() - start_ >= *limit_; }

private:
    std::optional<Clock::duration> limit_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace mesher
