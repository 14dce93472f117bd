#include "cli/commands.h"
#include "io/mesh_writer.h"
#include "pipeline/stage_failure.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace mesher {

namespace {

template <class Command>
ExitStatus parseAndRun(Result<Command> command, ExitStatus (*run)(const Command&, Console), Console console)
{
    if (!command) return tell(command.error(), ExitStatus::Usage, console);
    return run(command.value(), console);
}

ExitStatus listFormats(Console console)
{
    for (const MeshFormat& format : meshFormats()) {
        console.out << format.name << std::string(12 - format.name.size(), ' ') << format.extension << "  "
                    << format.description << '\n';
    }
    return ExitStatus::Done;
}

/// By itself or behind a command: a file of such a name is written as ./-h.
bool asksForHelp(std::span<const std::string> arguments)
{
    const bool isFirst = !arguments.empty() && arguments.front() == "help";
    return isFirst || std::any_of(arguments.begin(), arguments.end(),
                                  [](const std::string& word) { return word == "--help" || word == "-h"; });
}

ExitStatus dispatch(std::span<const std::string> arguments, Console console)
{
    const std::string command = arguments.empty() ? std::string() : arguments.front();
    if (asksForHelp(arguments)) {
        console.out << usageText();
        return ExitStatus::Done;
    }
    if (command == "--version") {
        console.out << "mesher " << MESHER_VERSION << '\n';
        return ExitStatus::Done;
    }
    if (command == "formats") return listFormats(console);
    if (command == "mesh") return parseAndRun(parseMeshCommand(arguments.subspan(1)), runMesh, console);
    if (command == "estimate")
        return parseAndRun(parseEstimateCommand(arguments.subspan(1)), runEstimate, console);
    if (command == "check") return parseAndRun(parseCheckCommand(arguments.subspan(1)), runCheck, console);
    if (command == "info") return parseAndRun(parseInfoCommand(arguments.subspan(1)), runInfo, console);
    if (command == "draw") return parseAndRun(parseDrawCommand(arguments.subspan(1)), runDraw, console);
    const std::string message =
        command.empty() ? "the command is missing" : "unknown command '" + command + "'";
    return tell({ErrorCode::InvalidArgument, message, {}, {}, "see mesher --help"}, ExitStatus::Usage,
                console);
}

}  // namespace

Error inModel(Error error, const std::filesystem::path& model)
{
    constexpr std::array<std::string_view, 4> kKinds = {"Vertex", "Edge", "Face", "Solid"};
    std::string& entity = error.entity;
    const bool isPart = std::any_of(kKinds.begin(), kKinds.end(),
                                    [&](std::string_view kind) { return entity.starts_with(kind); });
    if (isPart) {
        entity = model.string() + ", " + entity;
    } else if (entity == "model" || entity == "mesh") {
        entity = model.string();
    }
    return error;
}

ExitStatus tell(const Error& error, ExitStatus status, Console console)
{
    console.err << "mesher: " << describe(error) << '\n';
    return status;
}

ExitStatus runMesher(std::span<const std::string> arguments, Console console)
{
    try {
        return dispatch(arguments, console);
    } catch (...) {
        return tell(errorInFlight(""), ExitStatus::Failed, console);
    }
}

}  // namespace mesher
