#pragma once

#include "base/run_context.h"

namespace mesher {

/// Lets SIGINT and SIGTERM cancel a run while the object lives. What cannot be cancelled from inside (the CAD kernel reading a
/// file) is done in the phase Immediate, in which a signal ends the program at once; nothing may be open for writing then. A
/// second signal always ends the program at once.
class InterruptScope
{
public:
    enum class Phase
    {
        Immediate,
        Cooperative
    };

    explicit InterruptScope(RunContext& context);
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;

    void enter(Phase phase);
};

}  // namespace mesher
