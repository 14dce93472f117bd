#include "cli/supervisor.h"

#include "cli/crash_report.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <new>

namespace mesher {

namespace {

using Clock = std::chrono::steady_clock;  // one for all processes

/// What a run has beyond its limit of time to end by itself.
constexpr std::chrono::milliseconds kGrace{1200};
constexpr std::size_t kStageLength = 64;

/// In memory that both processes see. The stage is read when the run is over.
struct RunNotes
{
    std::atomic<Clock::rep> end{0};  ///< 0: no limit
    char stage[kStageLength] = {};
};
static_assert(std::atomic<Clock::rep>::is_always_lock_free, "processes share it");

RunNotes* notes = nullptr;
int supervisor = 0;

RunNotes* makeNotes()
{
    void* memory = mmap(nullptr, sizeof(RunNotes), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return memory == MAP_FAILED ? nullptr : new (memory) RunNotes();
}

/// The signals that the waiting process takes one by one.
sigset_t heardSignals()
{
    sigset_t heard;
    sigemptyset(&heard);
    for (const int number : {SIGCHLD, SIGINT, SIGTERM}) sigaddset(&heard, number);
    return heard;
}

/// Waits for one run.
class Supervisor
{
public:
    Supervisor(pid_t child, const RunNotes& seen) : child_(child), notes_(seen) {}

    /// The status of waitpid.
    int wait()
    {
        int status = 0;
        const sigset_t heard = heardSignals();
        while (waitpid(child_, &status, WNOHANG) != child_) {
            siginfo_t info{};
            const timespec most = timeToWait();
            const int number = sigtimedwait(&heard, &info, &most);
            if (number == SIGINT || number == SIGTERM) {
                isAsked_ = true;
                kill(child_, kHandedOn);
            }
            if (isOver()) {
                isTimeUp_ = true;
                kill(child_, SIGKILL);
            }
        }
        return status;
    }
    [[nodiscard]] bool isAsked() const { return isAsked_; }
    [[nodiscard]] bool isTimeUp() const { return isTimeUp_; }

private:
    /// The limit may be set at any time, so it is looked at now and then.
    [[nodiscard]] timespec timeToWait() const
    {
        constexpr Clock::duration kMost = std::chrono::milliseconds(250);
        const Clock::rep end = notes_.end.load();
        const Clock::duration left =
            end == 0 ? kMost
                     : Clock::time_point(Clock::duration(end)) - Clock::now() + std::chrono::milliseconds(1);
        const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(
            std::clamp<Clock::duration>(left, std::chrono::milliseconds(1), kMost));
        return {0, static_cast<long>(nanoseconds.count())};
    }
    [[nodiscard]] bool isOver() const
    {
        const Clock::rep end = notes_.end.load();
        return end != 0 && Clock::now().time_since_epoch().count() >= end;
    }

    pid_t child_;
    const RunNotes& notes_;
    bool isAsked_ = false;
    bool isTimeUp_ = false;
};

ExitStatus runAsChild(pid_t parent, const sigset_t& mask, const std::vector<std::string>& arguments,
                      Console console)
{
    supervisor = parent;
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    sigprocmask(SIG_SETMASK, &mask, nullptr);
    if (getppid() != parent) return ExitStatus::Cancelled;
    return runMesher(arguments, console);
}

ExitStatus tellEnd(const Supervisor& run, int status, const std::vector<std::string>& arguments,
                   Console console)
{
    if (WIFEXITED(status)) return static_cast<ExitStatus>(WEXITSTATUS(status));
    const int number = WTERMSIG(status);
    if (run.isAsked() || number == SIGINT || number == SIGTERM || number == SIGHUP)
        return ExitStatus::Cancelled;
    if (number == SIGPIPE) std::raise(SIGPIPE);
    return tellCrash({number, run.isTimeUp(), notes->stage}, arguments, console);
}

}  // namespace

ExitStatus runSupervised(const std::vector<std::string>& arguments, Console console)
{
    notes = makeNotes();
    if (notes == nullptr) return runMesher(arguments, console);
    const sigset_t heard = heardSignals();
    sigset_t mask;
    sigprocmask(SIG_BLOCK, &heard, &mask);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) return runAsChild(parent, mask, arguments, console);
    if (child < 0) {
        sigprocmask(SIG_SETMASK, &mask, nullptr);
        return runMesher(arguments, console);
    }
    Supervisor run(child, *notes);
    const int status = run.wait();
    return tellEnd(run, status, arguments, console);
}

bool isSupervised() { return supervisor != 0; }

int supervisorProcess() { return supervisor; }

void noteStage(std::string_view stage)
{
    if (notes == nullptr) return;
    const std::size_t length = std::min(stage.size(), kStageLength - 1);
    std::memcpy(notes->stage, stage.data(), length);
    notes->stage[length] = '\0';
}

void noteTimeLimit(std::optional<double> seconds)
{
    constexpr double kLongest = 1e9;
    if (notes == nullptr) return;
    if (!seconds || !(*seconds < kLongest)) {
        notes->end.store(0);
        return;
    }
    const auto left = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
    notes->end.store((Clock::now() + left + kGrace).time_since_epoch().count());
}

}  // namespace mesher
