#pragma once

#include "cli/commands.h"
#include "cli/exit_status.h"

#include <csignal>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mesher {

/// Runs the program in a process of its own and waits for it. The CAD kernel crashes on some damaged files and does not return from
/// others, and nobody inside of its process can go on from there: the waiting process tells such an end as any other error, with
/// the stage, and in the report.
/// Guarantees   SIGINT and SIGTERM go on to the run, each once; the run does not outlive the waiting process
/// Returns      what the run returned; Failed for one that a signal ended, Cancelled if the caller had sent that
/// Cost         a fork of a process of a few megabytes, below a millisecond; where none can be made, the program runs in this one
[[nodiscard]] ExitStatus runSupervised(const std::vector<std::string>& arguments, Console console);

/// Whether someone waits for this process who tells its crashes.
[[nodiscard]] bool isSupervised();
/// The process that waits for this one, 0 if none does.
[[nodiscard]] int supervisorProcess();

/// What the waiting process hands SIGINT and SIGTERM on as: such a signal of a whole group may be pending in the run already, and the
/// system keeps one of each kind only.
inline constexpr int kHandedOn = SIGUSR1;

/// What the run is about; told if it crashes.
void noteStage(std::string_view stage);
/// The run is to end by itself within so many seconds from now; one that is still there soon after is ended. Nothing lifts it.
void noteTimeLimit(std::optional<double> seconds);

}  // namespace mesher
