#include "brep/model_inspection.h"
#include "brep/occt/read_model.h"
#include "cli/commands.h"

namespace mesher {

ExitStatus runInfo(const InfoCommand& command, Console console)
{
    const Result<ReadModel> read = readModel(command.model);
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
