#pragma once

#include "base/run_context.h"

#include <filesystem>
#include <string>

namespace mesher {

/// Lets SIGINT and SIGTERM cancel a run while the object lives. What cannot be cancelled from inside (the CAD kernel reading a
/// file) is done in the phase Immediate, in which a signal ends the program at once; nothing may be half written then. A second
/// signal always ends the program at once, but for the phase Ending: files appear, and a signal comes too late.
class InterruptScope
{
public:
    enum class Phase
    {
        Immediate,
        Cooperative,
        Ending
    };

    explicit InterruptScope(RunContext& context);
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;

    void enter(Phase phase);

    /// What a signal that ends the program at once leaves in a file: the report of a run has to be there even then.
    void leaveBehind(const std::filesystem::path& target, std::string text);
};

}  // namespace mesher
