#pragma once

#include "base/run_context.h"
#include "base/stop_reason.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace mesher {

/// How far a loop may go, besides the time that the context of the run sets. A default-made one limits nothing.
struct BudgetLimits
{
    static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

    std::uint64_t maxOperations = kUnlimited;  ///< operations begun: insertions, flips, …; 0 allows none
    std::uint64_t maxVertices = kUnlimited;    ///< vertices at which the loop stops
    std::uint64_t maxElements = kUnlimited;    ///< triangles or tets at which the loop stops
};

/// What a loop has reached, for the limits that count things other than operations.
struct BudgetUse
{
    std::uint64_t vertices = 0;
    std::uint64_t elements = 0;
};

/// Asked before each operation of every loop that could otherwise run without end:
///     while (auto entry = queue.pop()) { if (!budget.allows({vertexCount, elementCount})) break; … }
/// Once it has refused it keeps refusing for the same reason.
/// Cost  a few compares; the context is asked, and the clock read, once in kOperationsPerAsk operations.
class Budget
{
public:
    static constexpr std::uint64_t kOperationsPerAsk = 64;

    Budget(const BudgetLimits& limits, RunContext& context);

    /// Whether one more operation may begin; counts it if so.
    [[nodiscard]] bool allows(BudgetUse use = {});

    /// Operations allowed so far.
    [[nodiscard]] std::uint64_t operations() const { return operations_; }
    /// Why the budget refused; none as long as it has not.
    [[nodiscard]] std::optional<StopReason> exhausted() const { return exhausted_; }
    /// Why it refused, or what the loop itself found out when it ended without being refused.
    [[nodiscard]] StopReason stopReason(StopReason otherwise = StopReason::Done) const
    {
        return exhausted_.value_or(otherwise);
    }

private:
    [[nodiscard]] std::optional<StopReason> findLimitReached(BudgetUse use) const;

    BudgetLimits limits_;
    RunContext& context_;
    std::uint64_t operations_ = 0;
    std::optional<StopReason> exhausted_;
};

}  // namespace mesher
