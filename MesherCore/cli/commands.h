#pragma once

#include "cli/command_line.h"
#include "cli/exit_status.h"

#include <filesystem>
#include <ostream>
#include <span>
#include <string>

namespace mesher {

/// Where a command talks to.
struct Console
{
    std::ostream& out;
    std::ostream& err;
    bool hasProgress = false;  ///< `err` is a terminal
};

[[nodiscard]] ExitStatus runMesh(const MeshCommand& command, Console console);
[[nodiscard]] ExitStatus runEstimate(const MeshCommand& command, Console console);
[[nodiscard]] ExitStatus runCheck(const CheckCommand& command, Console console);
[[nodiscard]] ExitStatus runInfo(const InfoCommand& command, Console console);
[[nodiscard]] ExitStatus runDraw(const DrawCommand& command, Console console);

/// An error about an entity of a model, or about the "model", says which file that is.
[[nodiscard]] Error inModel(Error error, const std::filesystem::path& model);

/// Tells the error on `err` as one sentence behind the program's name.
ExitStatus tell(const Error& error, ExitStatus status, Console console);

/// The program: arguments without its own name.
[[nodiscard]] ExitStatus runMesher(std::span<const std::string> arguments, Console console);

}  // namespace mesher
