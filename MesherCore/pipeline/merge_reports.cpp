#include "pipeline/merge_reports.h"

#include "pipeline/report_entries.h"

#include <algorithm>
#include <utility>

namespace mesher {

void addReport(const ModelComponent& component, const MeshReport& part, MeshReport& whole)
{
    for (const auto& [name, count] : part.counts) addToEntry(whole.counts, name, count);
    for (const auto& [name, spent] : part.seconds) addToEntry(whole.seconds, name, spent);
    for (const auto& [name, spent] : part.cpuSeconds) addToEntry(whole.cpuSeconds, name, spent);
    if (const auto& angles = part.anglesBeforeImprovement) {
        if (!whole.anglesBeforeImprovement) whole.anglesBeforeImprovement = DihedralRange{};
        DihedralRange& all = *whole.anglesBeforeImprovement;
        all = {std::min(all.least, angles->least), std::max(all.largest, angles->largest)};
    }
    for (Error error : part.failures) {
        error.entity = component.inWhole(error.entity);
        error.message = component.inWhole(error.message);
        whole.failures.push_back(std::move(error));
    }
    for (LeftElements left : part.left) {
        left.reason = component.inWhole(left.reason);
        for (std::string& entity : left.entities) entity = component.inWhole(entity);
        whole.left.push_back(std::move(left));
    }
    for (LeftFaces left : part.nonDelaunay) {
        left.reason = component.inWhole(left.reason);
        for (std::string& entity : left.entities) entity = component.inWhole(entity);
        whole.nonDelaunay.push_back(std::move(left));
    }
    for (const std::string& warning : part.warnings) whole.warnings.push_back(component.inWhole(warning));
    if (part.status == MeshReport::Status::Cancelled || whole.status == MeshReport::Status::Done)
        whole.status = part.status;
    if (whole.stopReason == StopReason::Done) whole.stopReason = part.stopReason;
}

}  // namespace mesher
