#include "base/budget.h"

namespace mesher {

Budget::Budget(const BudgetLimits& limits, RunContext& context) : limits_(limits), context_(context) {}

bool Budget::allows(BudgetUse use)
{
    if (!exhausted_) exhausted_ = findLimitReached(use);
    if (exhausted_) return false;
    ++operations_;
    return true;
}

std::optional<StopReason> Budget::findLimitReached(BudgetUse use) const
{
    if (context_.isCancelled()) return StopReason::Cancelled;
    if (operations_ % kOperationsPerAsk == 0) {
        if (const std::optional<StopReason> reason = context_.stopReason()) return reason;
    }
    if (operations_ >= limits_.maxOperations) return StopReason::OperationLimit;
    if (use.vertices >= limits_.maxVertices) return StopReason::VertexLimit;
    if (use.elements >= limits_.maxElements) return StopReason::ElementLimit;
    return std::nullopt;
}

}  // namespace mesher
