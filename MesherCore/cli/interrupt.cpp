#include "cli/interrupt.h"

#include "cli/exit_status.h"
#include "cli/supervisor.h"
#include "io/file_target.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

namespace mesher {

namespace {

using Phase = InterruptScope::Phase;

/// A file that is written in the handler: names and text are made before, since nothing may be allocated there.
struct LastWords
{
    std::string target;
    std::string temporary;
    std::string text;
};

// A signal handler has nothing but globals to go by.
std::atomic<RunContext*> activeContext = nullptr;
std::atomic<Phase> activePhase = Phase::Immediate;
std::atomic<const LastWords*> lastWords = nullptr;

static_assert(std::atomic<RunContext*>::is_always_lock_free && std::atomic<Phase>::is_always_lock_free);

void writeLastWords(const LastWords& words)
{
    const int descriptor = open(words.temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) return;
    const auto size = static_cast<ssize_t>(words.text.size());
    const bool isWhole = ::write(descriptor, words.text.data(), words.text.size()) == size;
    close(descriptor);
    if (!isWhole || rename(words.temporary.c_str(), words.target.c_str()) != 0)
        unlink(words.temporary.c_str());
}

/// A process that waits for this one hears what the terminal or a group is sent as well and hands it on, so that only what comes
/// from there counts. Once it is gone nobody else would end a run that does not listen.
bool isMeant(int number)
{
    constexpr unsigned kPatience = 2;  // seconds
    const int waiting = supervisorProcess();
    if (waiting == 0) return true;
    if (getppid() != waiting) alarm(kPatience);
    return number == kHandedOn;
}

std::vector<int> heardBy(bool isSupervised)
{
    std::vector<int> numbers = {SIGINT, SIGTERM};
    if (isSupervised) numbers.push_back(kHandedOn);
    return numbers;
}

extern "C" void onSignal(int number)
{
    const Phase phase = activePhase.load();
    if (phase == Phase::Ending || !isMeant(number)) return;
    RunContext* context = activeContext.load();
    if (context != nullptr && phase == Phase::Cooperative && !context->isCancelled()) {
        context->requestCancel();
        return;
    }
    if (const LastWords* words = lastWords.load()) writeLastWords(*words);
    constexpr std::string_view message = "\nmesher: cancelled\n";
    static_cast<void>(!::write(STDERR_FILENO, message.data(), message.size()));
    _exit(static_cast<int>(ExitStatus::Cancelled));
}

}  // namespace

InterruptScope::InterruptScope(RunContext& context)
{
    activeContext.store(&context);
    struct sigaction action
    {
    };
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int number : heardBy(isSupervised())) sigaction(number, &action, nullptr);
}

InterruptScope::~InterruptScope()
{
    // The status of a supervised run is decided: a signal on its way out must not make it look cancelled.
    const auto after = isSupervised() ? SIG_IGN : SIG_DFL;
    for (const int number : heardBy(isSupervised())) std::signal(number, after);
    activeContext.store(nullptr);
    activePhase.store(Phase::Immediate);
    delete lastWords.exchange(nullptr);
}

void InterruptScope::enter(Phase phase) { activePhase.store(phase); }

void InterruptScope::leaveBehind(const std::filesystem::path& target, std::string text)
{
    std::filesystem::path end = target;
    bool isDirect = false;
    if (findObstacle(end, isDirect) || isDirect) return;
    const std::string temporary = (folderOf(end) / (".partial-" + std::to_string(getpid()))).string();
    delete lastWords.exchange(new LastWords{end.string(), temporary, std::move(text)});
}

}  // namespace mesher
