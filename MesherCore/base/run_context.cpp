#include "base/run_context.h"

#include "base/assert.h"

#include <algorithm>
#include <utility>

namespace mesher {

RunContext::RunContext(RunSettings settings) : settings_(std::move(settings))
{
    MESHER_PRECONDITION(settings_.threads >= 1);
}

void RunContext::limitTime(std::chrono::steady_clock::time_point end)
{
    end_ = end_ ? std::min(*end_, end) : end;
}

void RunContext::limitTime(std::optional<double> seconds)
{
    using Clock = std::chrono::steady_clock;
    // Thirty years, which the clock can still count.
    constexpr double kMost = 1e9;
    if (!seconds || !(*seconds < kMost)) return;
    const std::chrono::duration<double> left(std::max(*seconds, 0.0));
    limitTime(Clock::now() + std::chrono::duration_cast<Clock::duration>(left));
}

std::optional<StopReason> RunContext::stopReason()
{
    if (settings_.poll && !isCancelled() && std::this_thread::get_id() == home_ && !settings_.poll())
        requestCancel();
    if (isCancelled()) return StopReason::Cancelled;
    if (end_ && std::chrono::steady_clock::now() >= *end_) return StopReason::TimeLimit;
    return std::nullopt;
}

void RunContext::enterStage(std::string_view stage)
{
    if (stage == stage_) return;
    stage_ = stage;
    if (settings_.stage) settings_.stage(stage);
}

bool RunContext::reportProgress(std::string_view stage, double fraction)
{
    enterStage(stage);
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
    if (done_ < nextReport_ || done_ == stepCount_)
        return done_ % kStepsPerAsk == 0 ? context_.mayGoOn() : !context_.isCancelled();
    nextReport_ = done_ + stepsPerReport(stepCount_);
    return report() && context_.mayGoOn();
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
