#include "base/run_context.h"

#include "base/assert.h"

#include <algorithm>
#include <utility>

namespace mesher {

RunContext::RunContext(RunSettings settings) : settings_(std::move(settings))
{
    MESHER_PRECONDITION(settings_.threads >= 1);
}

bool RunContext::reportProgress(std::string_view stage, double fraction)
{
    if (isCancelled()) return false;
    if (settings_.progress && !settings_.progress(stage, fraction)) requestCancel();
    return !isCancelled();
}

void RunContext::log(LogLevel level, std::string_view message) const
{
    if (settings_.log) settings_.log(level, message);
}

namespace {

std::uint64_t stepsPerReport(std::uint64_t stepCount) { return std::max<std::uint64_t>(1, stepCount / 100); }

}  // namespace

StageProgress::StageProgress(RunContext& context, std::string_view stage, std::uint64_t stepCount)
    : context_(context), stage_(stage), stepCount_(stepCount), nextReport_(stepsPerReport(stepCount))
{
}

bool StageProgress::advance(std::uint64_t steps)
{
    done_ = std::min(done_ + steps, stepCount_);
    if (done_ < nextReport_ || done_ == stepCount_) return !context_.isCancelled();
    nextReport_ = done_ + stepsPerReport(stepCount_);
    return report();
}

bool StageProgress::finish()
{
    if (isFinished_) return !context_.isCancelled();
    isFinished_ = true;
    done_ = stepCount_;
    return report();
}

bool StageProgress::report()
{
    const double fraction =
        stepCount_ == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(stepCount_);
    return context_.reportProgress(stage_, fraction);
}

}  // namespace mesher
