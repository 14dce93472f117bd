#include "brep/model_inspection.h"
#include "cli/commands.h"
#include "cli/model_file.h"

namespace mesher {

ExitStatus runInfo(const InfoCommand& command, Console console)
{
    const Result<ReadModel> read = readModelFile(command.model, false, "measures");
    if (!read) return tell(read.error(), ExitStatus::Failed, console);
    const ModelFacts facts = inspectModel(read.value().model);
    if (command.isJson) {
        console.out << jsonOf(facts) << '\n';
    } else {
        console.out << "format: " << read.value().format << '\n' << textOf(facts);
    }
    return ExitStatus::Done;
}

}  // namespace mesher
