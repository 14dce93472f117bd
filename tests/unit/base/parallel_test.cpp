#include "base/parallel.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace mesher {
namespace {

RunSettings withThreads(unsigned threads)
{
    RunSettings settings;
    settings.threads = threads;
    return settings;
}

TEST(Parallel, DoesEachTaskOnce)
{
    for (const unsigned threads : {1u, 4u}) {
        RunContext context(withThreads(threads));
        std::vector<std::atomic<int>> done(1000);
        forEachInParallel(done.size(), context, [&](std::size_t i) { ++done[i]; });
        for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
        EXPECT_EQ(context.missingThreads(), 0u);
    }
}

TEST(Parallel, ThrowsHereWhatATaskThrows)
{
    for (const unsigned threads : {1u, 4u}) {
        RunContext context(withThreads(threads));
        const auto task = [](std::size_t i) {
            if (i == 17) throw std::runtime_error("seventeen");
        };
        EXPECT_THROW(forEachInParallel(100, context, task), std::runtime_error);
    }
}

/// Ends with 0 if all was done although there was no memory for the stacks of so many threads.
[[noreturn]] void runWithoutMemoryForThreads()
{
    constexpr rlim_t kRoom = rlim_t{256} << 20;
    const rlimit limit{kRoom, kRoom};
    if (setrlimit(RLIMIT_AS, &limit) != 0) std::exit(2);
    RunContext context(withThreads(500));
    std::atomic<int> done = 0;
    forEachInParallel(1000, context, [&](std::size_t) { ++done; });
    std::exit(done == 1000 && context.missingThreads() > 0 ? 0 : 1);
}

TEST(Parallel, DoesWithoutThreadsThatTheSystemDoesNotGive)
{
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer needs more address space than the test leaves";
#endif
    EXPECT_EXIT(runWithoutMemoryForThreads(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace mesher
