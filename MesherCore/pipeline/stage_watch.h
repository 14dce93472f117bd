#pragma once

#include "pipeline/mesh_report.h"

#include <chrono>
#include <ctime>
#include <string>

namespace mesher {

/// Measures a stage from when it is made. The time on the clock is what users wait for; on a busy machine only that of the
/// processor tells what a stage costs.
class StageWatch
{
public:
    /// Adds what has passed to the stage of that name, which comes last in the report if it is new.
    void addTo(MeshReport& report, const std::string& stage) const;

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::clock_t cpuStart_ = std::clock();
};

}  // namespace mesher
