#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace mesher::test {

/// How a process of its own ended, and the last that it said of itself.
struct ProcessEnd
{
    enum class Kind
    {
        Answered,  ///< the work returned; `text` is its answer
        Crashed,   ///< by a signal, an exception or an exit of its own; `text` says by which
        RanOutOfTime,
        RanOutOfMemory
    };
    Kind kind = Kind::Crashed;
    std::string phase;  ///< what the work last said it was about
    std::string text;
};

/// Tells the parent what the process is about; from there on it has this time, in seconds of the processor.
using EnterPhase = std::function<void(const std::string& phase, std::uint64_t seconds)>;

/// Runs the work in a process of its own, without its output.
/// Requires     no thread beside the caller's
[[nodiscard]] ProcessEnd runLimited(const std::function<std::string(const EnterPhase&)>& work,
                                    std::uint64_t memoryMegabytes);

}  // namespace mesher::test
