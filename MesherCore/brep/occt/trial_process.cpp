#include "brep/occt/trial_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <optional>
#include <thread>

namespace mesher {

namespace {

constexpr int kDone = 0;
constexpr int kThrown = 117;  // unlike what handlers of crashes end with
constexpr std::array kCrashSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

[[noreturn]] void runAlone(const std::function<void()>& step)
{
    // The caller's handlers may make a crash look like an ordinary end, and would speak of it.
    for (const int number : kCrashSignals) std::signal(number, SIG_DFL);
    const int nothing = open("/dev/null", O_WRONLY);
    if (nothing >= 0) {
        dup2(nothing, STDOUT_FILENO);
        dup2(nothing, STDERR_FILENO);
    }
    try {
        step();
    } catch (...) {
        // An exception is no crash: the caller will meet it again.
        _exit(kThrown);
    }
    _exit(kDone);
}

/// Time of the processor that a process has used; nothing if that cannot be told.
std::optional<double> secondsUsedBy(pid_t process)
{
    clockid_t clock = 0;
    timespec used{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &used) != 0) return std::nullopt;
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// Waits for the child's end. Nothing if it stands still: it has no other threads, and locks that these held when it was forked
/// are never let go.
std::optional<int> statusOf(pid_t child)
{
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::seconds kPatience{5};
    constexpr std::chrono::microseconds kShortest{200}, kLongest{10000};
    Clock::time_point moved = Clock::now();
    std::optional<double> used;
    std::chrono::microseconds pause = kShortest;
    int status = 0;
    for (;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child) return status;
        if (ended < 0 && errno != EINTR) return std::nullopt;
        const std::optional<double> now = secondsUsedBy(child);
        if (now != used) moved = Clock::now();
        used = now;
        if (Clock::now() - moved > kPatience) break;
        std::this_thread::sleep_for(pause);
        pause = std::min(2 * pause, kLongest);
    }
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return std::nullopt;
}

}  // namespace

bool endsByItself(const std::function<void()>& step)
{
    const pid_t child = fork();
    if (child < 0) return true;
    if (child == 0) runAlone(step);
    const std::optional<int> status = statusOf(child);
    if (!status) return true;
    return WIFEXITED(*status) && (WEXITSTATUS(*status) == kDone || WEXITSTATUS(*status) == kThrown);
}

}  // namespace mesher
