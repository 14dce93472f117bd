#include "cli/interrupt.h"

#include "cli/exit_status.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

namespace mesher {

namespace {

// A signal handler has nothing but globals to go by.
std::atomic<RunContext*> activeContext = nullptr;
std::atomic<bool> endsAtOnce = true;

static_assert(std::atomic<RunContext*>::is_always_lock_free);

extern "C" void onSignal(int)
{
    RunContext* context = activeContext.load();
    if (context != nullptr && !endsAtOnce.exchange(true)) {
        context->requestCancel();
        return;
    }
    constexpr std::string_view message = "\nmesher: cancelled\n";
    static_cast<void>(!::write(STDERR_FILENO, message.data(), message.size()));
    _exit(static_cast<int>(ExitStatus::Cancelled));
}

}  // namespace

InterruptScope::InterruptScope(RunContext& context)
{
    activeContext.store(&context);
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
}

InterruptScope::~InterruptScope()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    activeContext.store(nullptr);
    endsAtOnce.store(true);
}

void InterruptScope::enter(Phase phase) { endsAtOnce.store(phase == Phase::Immediate); }

}  // namespace mesher
