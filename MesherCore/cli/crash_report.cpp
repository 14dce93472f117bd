#include "cli/crash_report.h"

#include "io/write_text_file.h"
#include "pipeline/mesh_report.h"

#include <csignal>
#include <cstring>
#include <filesystem>
#include <span>

namespace mesher {

namespace {

/// The file that the command is about; empty if its words make no sense.
std::filesystem::path modelOf(std::span<const std::string> arguments)
{
    if (arguments.empty()) return {};
    const auto words = arguments.subspan(1);
    const auto modelIn = [](const auto& command) {
        return command ? command.value().model : std::filesystem::path();
    };
    if (arguments[0] == "mesh") return modelIn(parseMeshCommand(words));
    if (arguments[0] == "estimate") return modelIn(parseEstimateCommand(words));
    if (arguments[0] == "info") return modelIn(parseInfoCommand(words));
    const Result<CheckCommand> check = parseCheckCommand(words);
    if (arguments[0] == "check" && check) return check.value().model.value_or(check.value().mesh);
    return {};
}

void writeReport(const Error& error, const Crash& crash, std::span<const std::string> arguments,
                 Console console)
{
    if (arguments.empty() || arguments[0] != "mesh") return;
    const Result<MeshCommand> command = parseMeshCommand(arguments.subspan(1));
    if (!command || !command.value().report) return;
    MeshReport report;
    report.status = MeshReport::Status::Failed;
    if (crash.isTimeUp) report.stopReason = StopReason::TimeLimit;
    report.failures = {error};
    report.modelFile = command.value().model.string();
    report.options = command.value().options;
    report.versions = {{"mesher", MESHER_VERSION}};
    const Result<void> written = writeTextFile(toJson(report), *command.value().report);
    if (!written) tell(written.error(), ExitStatus::Failed, console);
}

}  // namespace

Error errorOf(const Crash& crash)
{
    const bool isReading = crash.stage == kReadingStage;
    const std::string during = crash.stage.empty() ? "" : ", in the stage '" + crash.stage + "'";
    const auto about = [&](std::string message, std::string remedy) {
        return Error{ErrorCode::Unreadable, std::move(message) + during, "model", {}, std::move(remedy)};
    };
    if (crash.isTimeUp)
        return about("the time limit is over and the run did not end by itself",
                     isReading ? "export the model again or raise --timeout"
                               : "choose a larger --size or raise --timeout");
    if (crash.signal == SIGKILL)
        return about("the system ended the run, most likely since the memory does not suffice",
                     "choose a larger --size or a machine with more memory");
    if (crash.signal == SIGXCPU) return about("the limit on CPU time is reached", "raise it");
    if (crash.signal == SIGXFSZ)
        return about("the limit on the size of files is reached", "raise it or write a smaller mesh");
    const std::string how = std::string(" (") + strsignal(crash.signal) + ")";
    if (isReading)
        return about("the file is damaged: the CAD kernel crashed on it" + how, "export the model again");
    return about("the run crashed" + how, "repair the model or report it as a fault of the mesher");
}

ExitStatus tellCrash(const Crash& crash, const std::vector<std::string>& arguments, Console console)
{
    const Error error = errorOf(crash);
    if (console.hasProgress) console.err << '\n';
    tell(inModel(error, modelOf(arguments)), ExitStatus::Failed, console);
    writeReport(error, crash, arguments, console);
    return ExitStatus::Failed;
}

}  // namespace mesher
