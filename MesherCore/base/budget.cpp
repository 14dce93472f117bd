#include "base/budget.h"

namespace mesher {

Budget::Budget(const BudgetLimits& limits, RunContext& context)
    : limits_(limits), context_(context), start_(std::chrono::steady_clock::now())
{
}

bool Budget::allows(BudgetUse use)
{
    if (!exhausted_) exhausted_ = findLimitReached(use);
    if (exhausted_) return false;
    ++operations_;
    return true;
}

std::optional<StopReason> Budget::findLimitReached(BudgetUse use) const
{
    const bool isAskedNow = operations_ % kOperationsPerClockReading == 0;
    if (context_.isCancelled()) return StopReason::Cancelled;
    if (isAskedNow) {
        if (const std::optional<StopReason> reason = context_.stopReason()) return reason;
    }
    if (operations_ >= limits_.maxOperations) return StopReason::OperationLimit;
    if (use.vertices >= limits_.maxVertices) return StopReason::VertexLimit;
    if (use.elements >= limits_.maxElements) return StopReason::ElementLimit;
    if (limits_.maxTime && isAskedNow && std::chrono::steady_clock::now() - start_ >= *limits_.maxTime) {
        return StopReason::TimeLimit;
    }
    return std::nullopt;
}

}  // namespace mesher
