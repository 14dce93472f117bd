#pragma once

#include "cli/commands.h"
#include "cli/exit_status.h"

#include <string>
#include <string_view>
#include <vector>

namespace mesher {

/// The stage in which the CAD kernel reads a file.
inline constexpr std::string_view kReadingStage = "reading the model";

/// How a run ended that did not return.
struct Crash
{
    int signal = 0;
    bool isTimeUp = false;  ///< it was ended since its time was over
    std::string stage;      ///< the last that it told
};

/// What is said of it, with a remedy.
[[nodiscard]] Error errorOf(const Crash& crash);

/// Tells the error about the model of the command, and writes the report of a mesh command that asks for one.
ExitStatus tellCrash(const Crash& crash, const std::vector<std::string>& arguments, Console console);

}  // namespace mesher
