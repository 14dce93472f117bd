#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>

namespace mesher {

/// Calls `task(i)` for i in [0, count), on up to `threads` threads; returns when all are done. Tasks must not depend on each
/// other or on their order.
template <class Task>
void forEachInParallel(std::size_t count, unsigned threads, Task&& task)
{
    if (threads <= 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i) task(i);
        return;
    }
    // The caller's number holds, also where it is above that of the machine.
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(static_cast<int>(threads));
    arena.execute([&] {
        // One face may cost a thousand times what another does, so each is a task of its own.
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t i = range.begin(); i != range.end(); ++i) task(i);
            },
            tbb::simple_partitioner());
    });
}

}  // namespace mesher
