#pragma once

#include "point_file.h"

#include <cstddef>
#include <cstdio>
#include <malloc.h>
#include <sys/resource.h>

// What every program under comparison measures, in the same way. Stands alone, like point_file.h.

namespace compare {

/// User CPU seconds of this process so far.
inline double userCpuSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// Bytes handed out by the heap and not given back, with large blocks that are mapped one by one.
inline double heapBytes()
{
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// Growth of the heap and of the CPU time from its making on. The input is to be in memory before.
class Measurement
{
public:
    void stop()
    {
        seconds_ = userCpuSeconds() - startSeconds_;
        bytes_ = heapBytes() - startBytes_;
    }

    /// One JSON object on one line. `simplices` are the finite triangles or tetrahedra; the bytes are what the
    /// finished triangulation holds, infinite (ghost) simplices included, per finite simplex.
    void print(std::size_t vertices, std::size_t simplices, std::size_t scaffold) const
    {
        const double bytesPerSimplex = simplices == 0 ? 0.0 : bytes_ / static_cast<double>(simplices);
        std::printf(
            "{\"cpu_seconds\": %.6f, \"vertices\": %zu, \"simplices\": %zu, \"bytes_per_simplex\": %.2f, "
            "\"scaffold\": %zu}\n",
            seconds_, vertices, simplices, bytesPerSimplex, scaffold);
    }

private:
    double startBytes_ = heapBytes();
    double startSeconds_ = userCpuSeconds();
    double seconds_ = 0.0;
    double bytes_ = 0.0;
};

/// The one argument is a point file; tells what is wrong and returns false otherwise.
inline bool readArgument(int argumentCount, char** arguments, PointFile& points)
{
    if (argumentCount != 2) {
        std::fprintf(stderr, "usage: %s POINTS\n", arguments[0]);
        return false;
    }
    if (!readPointFile(arguments[1], points)) {
        std::fprintf(stderr, "%s: %s is not a complete point file\n", arguments[0], arguments[1]);
        return false;
    }
    return true;
}

}  // namespace compare
