#include "base/stop_reason.h"

#include "base/assert.h"

namespace mesher {

std::string_view nameOf(StopReason reason)
{
    switch (reason) {
        case StopReason::Done: return "done";
        case StopReason::CannotImprove: return "cannot_improve";
        case StopReason::OperationLimit: return "operation_limit";
        case StopReason::VertexLimit: return "vertex_limit";
        case StopReason::ElementLimit: return "element_limit";
        case StopReason::TimeLimit: return "time_limit";
        case StopReason::Cancelled: return "cancelled";
    }
    MESHER_INVARIANT(false);
    return "";
}

}  // namespace mesher
