#pragma once

#include <functional>

namespace mesher {

/// Runs a step in a process of its own and tells whether it came to its end there, rather than to a crash: for kernel code that
/// some damaged files bring down. Nothing that the step does is seen here, but for files.
/// Returns      true also where no process can be made, and where it stands still: a process that is forked beside other threads may
///              wait for a lock that one of these held
/// Cost         that of the step, once more
[[nodiscard]] bool endsByItself(const std::function<void()>& step);

}  // namespace mesher
