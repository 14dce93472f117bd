#include "pipeline/stage_watch.h"

#include "pipeline/report_entries.h"

namespace mesher {

void StageWatch::addTo(MeshReport& report, const std::string& stage) const
{
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    addToEntry(report.seconds, stage, passed.count());
    addToEntry(report.cpuSeconds, stage, static_cast<double>(std::clock() - cpuStart_) / CLOCKS_PER_SEC);
}

}  // namespace mesher
