#include "cli/model_file.h"

#include "cli/crash_report.h"
#include "cli/supervisor.h"

namespace mesher {

Result<ReadModel> readModelFile(const std::filesystem::path& path, bool heals, std::string_view next)
{
    noteStage(kReadingStage);
    Result<ReadModel> read = readModel(path, ReadOptions{heals, !isSupervised()});
    noteStage(next);
    return read;
}

}  // namespace mesher
