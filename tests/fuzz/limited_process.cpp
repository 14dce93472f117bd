#include "limited_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <typeinfo>

namespace mesher::test {

namespace {

constexpr int kThrown = 117;
constexpr int kOutOfMemory = 118;
constexpr char kPhaseMark = '\1';
constexpr char kAnswerMark = '\2';

void writeAll(int file, const std::string& text)
{
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = ::write(file, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return;
        done += static_cast<std::size_t>(count);
    }
}

void limitTime(std::uint64_t seconds)
{
    rusage used = {};
    getrusage(RUSAGE_SELF, &used);
    const rlim_t spent = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + 1;
    const rlimit limit = {spent + seconds, RLIM_INFINITY};
    setrlimit(RLIMIT_CPU, &limit);
}

void limitMemory(std::uint64_t megabytes)
{
    const rlimit limit = {static_cast<rlim_t>(megabytes << 20), static_cast<rlim_t>(megabytes << 20)};
    setrlimit(RLIMIT_AS, &limit);
    const rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
}

[[noreturn]] void runChild(const std::function<std::string(const EnterPhase&)>& work,
                           std::uint64_t memoryMegabytes, int out)
{
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) std::signal(number, SIG_DFL);
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    limitMemory(memoryMegabytes);
    try {
        const std::string answer = work([&](const std::string& phase, std::uint64_t seconds) {
            limitTime(seconds);
            writeAll(out, kPhaseMark + phase);
        });
        writeAll(out, kAnswerMark + answer);
        _exit(0);
    } catch (const std::bad_alloc&) {
        _exit(kOutOfMemory);
    } catch (const std::exception& thrown) {
        writeAll(out, kAnswerMark + std::string(typeid(thrown).name()) + ": " + thrown.what());
        _exit(kThrown);
    }
}

std::string readAll(int file)
{
    std::string text;
    std::array<char, 4096> block = {};
    for (;;) {
        const ssize_t count = ::read(file, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(block.data(), static_cast<std::size_t>(count));
    }
}

ProcessEnd endOf(const std::string& said, int status)
{
    ProcessEnd end;
    const std::size_t answer = said.find(kAnswerMark);
    const std::size_t phase = said.rfind(kPhaseMark, answer);
    if (phase != std::string::npos) end.phase = said.substr(phase + 1, answer - phase - 1);
    if (answer != std::string::npos) end.text = said.substr(answer + 1);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        end.kind = ProcessEnd::Kind::Answered;
    } else if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) {
        end.kind = ProcessEnd::Kind::RanOutOfMemory;
    } else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
        end.kind = ProcessEnd::Kind::RanOutOfTime;
    } else if (WIFSIGNALED(status)) {
        end.text = "signal " + std::to_string(WTERMSIG(status));
    } else if (WEXITSTATUS(status) != kThrown) {
        end.text = "exit status " + std::to_string(WEXITSTATUS(status));
    }
    return end;
}

}  // namespace

ProcessEnd runLimited(const std::function<std::string(const EnterPhase&)>& work,
                      std::uint64_t memoryMegabytes)
{
    std::array<int, 2> ends = {};
    if (pipe(ends.data()) != 0) return {ProcessEnd::Kind::Crashed, "", "no pipe"};
    const pid_t child = fork();
    if (child < 0) return {ProcessEnd::Kind::Crashed, "", "no process"};
    if (child == 0) {
        close(ends[0]);
        runChild(work, memoryMegabytes, ends[1]);
    }
    close(ends[1]);
    const std::string said = readAll(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return endOf(said, status);
}

}  // namespace mesher::test
