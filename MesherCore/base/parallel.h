#pragma once

#include "base/run_context.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace mesher {

/// Threads that share one piece of work, beside the one that called.
class HelperThreads
{
public:
    HelperThreads() = default;
    HelperThreads(const HelperThreads&) = delete;
    HelperThreads& operator=(const HelperThreads&) = delete;
    ~HelperThreads() { join(); }

    /// Makes threads that run `work`, or as many as the system has left; how many are missing. What one of them throws is kept.
    template <class Work>
    std::size_t start(std::size_t count, const Work& work)
    {
        threads_.reserve(count);
        try {
            while (threads_.size() < count) threads_.emplace_back([&] { guard(work); });
        } catch (const std::system_error&) {
            return count - threads_.size();
        }
        return 0;
    }
    /// Runs `work` here as well, waits for the others, and throws what one of them has thrown.
    template <class Work>
    void finish(const Work& work)
    {
        guard(work);
        join();
        if (thrown_) std::rethrow_exception(thrown_);
    }

private:
    template <class Work>
    void guard(const Work& work) noexcept
    {
        try {
            work();
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            if (!thrown_) thrown_ = std::current_exception();
        }
    }
    void join()
    {
        for (std::thread& thread : threads_) thread.join();
        threads_.clear();
    }

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::exception_ptr thrown_;
};

/// Calls `task(i)` for i in [0, count), on up to as many threads as the context says; returns when all are done. Tasks must not
/// depend on each other or on their order.
/// Guarantees   threads that the system does not give are told to the context, and the others do their work; what a task throws is
///              thrown here
template <class Task>
void forEachInParallel(std::size_t count, RunContext& context, Task&& task)
{
    std::atomic<std::size_t> next = 0;
    // One face may cost a thousand times what another does, so each is a task of its own.
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) task(i);
    };
    HelperThreads helpers;
    if (context.threads() > 1 && count > 1)
        context.noteMissingThreads(helpers.start(std::min<std::size_t>(context.threads(), count) - 1, work));
    helpers.finish(work);
}

}  // namespace mesher
