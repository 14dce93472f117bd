#pragma once

#include "base/stop_reason.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace mesher {

/// How much of the state is verified between steps, in every build type.
enum class CheckLevel
{
    Off,
    Local,  ///< constant work per operation
    Full    ///< the whole-mesh checkers
};

enum class LogLevel
{
    Debug,
    Info,
    Warning
};

/// Told how far a stage is, fraction in [0, 1]; returns false to cancel the run.
using ProgressHook = std::function<bool(std::string_view stage, double fraction)>;
/// Asked again and again wherever the run is, at least some ten times a second; returns false to cancel the run.
using PollHook = std::function<bool()>;
/// Told each stage that a run enters.
using StageHook = std::function<void(std::string_view stage)>;
using LogHook = std::function<void(LogLevel level, std::string_view message)>;

/// What a caller chooses for a run. A default-made one is silent, checks nothing and uses one thread.
/// The hooks are called on the thread that called the library.
struct RunSettings
{
    ProgressHook progress;
    PollHook poll;
    StageHook stage;
    LogHook log;
    std::uint64_t seed = 1;  ///< of every random choice of the run; the same seed gives the same mesh
    CheckLevel checkLevel = CheckLevel::Off;
    bool keepsPartial = true;  ///< what there is when the time is over is made into a mesh, which takes time
    unsigned threads = 1;      ///< at least 1; the result does not depend on it
};

/// Progress, cancellation, limit of time, log, seed and check level of one run, handed down by reference: the library has no
/// global state. One context serves one run; only `requestCancel`, `isCancelled`, `stopReason` and `mayGoOn` may be called from
/// other threads, and only the first two from signal handlers.
class RunContext
{
public:
    RunContext() = default;
    explicit RunContext(RunSettings settings);
    RunContext(const RunContext&) = delete;
    RunContext& operator=(const RunContext&) = delete;

    void requestCancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool isCancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

    /// The run is to end by then; of several limits the earliest counts.
    void limitTime(std::chrono::steady_clock::time_point end);
    void limitTime(std::optional<double> seconds);
    void limitTimeAs(const RunContext& other) { end_ = other.end_; }

    /// Why the run is to end now, if it is. Every loop that may take more than a tenth of a second asks this or a `Budget`, which
    /// does so. Costs a reading of the clock.
    [[nodiscard]] std::optional<StopReason> stopReason();
    [[nodiscard]] bool mayGoOn() { return !stopReason(); }

    /// Tells the progress hook; false if the run is to end, now or because it was cancelled before.
    bool reportProgress(std::string_view stage, double fraction);
    /// What the run is about from here on, for errors; progress of a stage enters it as well.
    void enterStage(std::string_view stage);
    /// The last stage that was entered; empty before the first.
    [[nodiscard]] const std::string& stage() const { return stage_; }
    void log(LogLevel level, std::string_view message) const;

    [[nodiscard]] std::uint64_t seed() const { return settings_.seed; }
    /// Whether anybody wants what there is of a mesh when the time is over.
    [[nodiscard]] bool keepsPartial() const { return settings_.keepsPartial; }
    [[nodiscard]] CheckLevel checkLevel() const { return settings_.checkLevel; }
    [[nodiscard]] unsigned threads() const { return settings_.threads; }
    /// Threads that the system did not give, at the worst time.
    [[nodiscard]] std::size_t missingThreads() const { return missingThreads_; }
    void noteMissingThreads(std::size_t count) { missingThreads_ = std::max(missingThreads_, count); }

private:
    friend class TimeLimitPause;
    static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may cancel");

    RunSettings settings_;
    std::thread::id home_ = std::this_thread::get_id();  ///< of the hooks
    std::optional<std::chrono::steady_clock::time_point> end_;
    std::string stage_;
    std::atomic<bool> cancelled_ = false;
    std::size_t missingThreads_ = 0;
};

/// Lifts the limit of time while it lives: for what is still to be made of a run whose time is over. Cancellation is heard.
class TimeLimitPause
{
public:
    explicit TimeLimitPause(RunContext& context, bool isPaused = true) : context_(context), end_(context.end_)
    {
        if (isPaused) context_.end_.reset();
    }
    TimeLimitPause(const TimeLimitPause&) = delete;
    TimeLimitPause& operator=(const TimeLimitPause&) = delete;
    ~TimeLimitPause() { context_.end_ = end_; }

private:
    RunContext& context_;
    std::optional<std::chrono::steady_clock::time_point> end_;
};

/// Asks a context once in many short steps, so that a step costs a count and a compare. What it has once refused it refuses
/// for good.
class StepWatch
{
public:
    explicit StepWatch(RunContext& context, std::uint32_t stepsPerAsk = 1024)
        : context_(context), stepsPerAsk_(stepsPerAsk)
    {
    }

    /// Whether one more step may begin.
    [[nodiscard]] bool mayGoOn()
    {
        if (steps_++ % stepsPerAsk_ == 0 && !reason_) reason_ = context_.stopReason();
        return !reason_;
    }
    [[nodiscard]] std::optional<StopReason> stopReason() const { return reason_; }

private:
    RunContext& context_;
    std::uint32_t stepsPerAsk_;
    std::uint32_t steps_ = 0;
    std::optional<StopReason> reason_;
};

/// Progress of one stage of known length: counts steps and tells the hook about each new hundredth only, so a
/// step costs an addition and a compare. Counting rather than timing keeps the calls reproducible. Asks the context on the way.
class StageProgress
{
public:
    /// `stage` must outlive this object (a string literal).
    StageProgress(RunContext& context, std::string_view stage, std::uint64_t stepCount);

    /// False if the run is to end.
    [[nodiscard]] bool advance(std::uint64_t steps = 1);
    /// Tells the hook that the stage is complete, once; false if the run is to end.
    bool finish();

private:
    [[nodiscard]] bool report();

    static constexpr std::uint64_t kStepsPerAsk = 64;

    RunContext& context_;
    std::string_view stage_;
    std::uint64_t stepCount_;
    std::uint64_t done_ = 0;
    std::uint64_t nextReport_;
    bool isFinished_ = false;
};

}  // namespace mesher
