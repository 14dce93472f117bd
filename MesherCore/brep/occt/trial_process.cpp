#include "brep/occt/trial_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

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

}  // namespace

bool endsByItself(const std::function<void()>& step)
{
    const pid_t child = fork();
    if (child < 0) return true;
    if (child == 0) runAlone(step);
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return true;
    }
    return WIFEXITED(status) && (WEXITSTATUS(status) == kDone || WEXITSTATUS(status) == kThrown);
}

}  // namespace mesher
