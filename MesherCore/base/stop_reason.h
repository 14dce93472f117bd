#pragma once

#include <string_view>

namespace mesher {

/// Why a loop ended. Only `Done` means that everything asked for was reached; none of them is an Error.
enum class StopReason
{
    Done,            ///< nothing is left to do
    CannotImprove,   ///< something is left, and no operation helps
    OperationLimit,  ///< BudgetLimits::maxOperations
    VertexLimit,     ///< BudgetLimits::maxVertices
    ElementLimit,    ///< BudgetLimits::maxElements
    TimeLimit,       ///< RunContext::limitTime
    Cancelled        ///< the caller asked to stop
};

/// The name in reports: snake_case, stable.
[[nodiscard]] std::string_view nameOf(StopReason reason);

}  // namespace mesher
