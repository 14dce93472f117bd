#include "pipeline/merge_reports.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Adds to the entry of that name, which is made if there is none.
template <typename Number>
void addTo(std::vector<std::pair<std::string, Number>>& entries, const std::string& name, Number amount)
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.first == name; });
    if (found == entries.end()) {
        entries.emplace_back(name, amount);
    } else {
        found->second += amount;
    }
}

}  // namespace

void addReport(const ModelComponent& component, const MeshReport& part, MeshReport& whole)
{
    for (const auto& [name, count] : part.counts) addTo(whole.counts, name, count);
    for (const auto& [name, spent] : part.seconds) addTo(whole.seconds, name, spent);
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
    for (const std::string& warning : part.warnings) whole.warnings.push_back(component.inWhole(warning));
    if (part.status == MeshReport::Status::Cancelled || whole.status == MeshReport::Status::Done)
        whole.status = part.status;
    if (whole.stopReason == StopReason::Done) whole.stopReason = part.stopReason;
}

}  // namespace mesher
