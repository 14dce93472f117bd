#pragma once

#include <cstdlib>

namespace mesher::test {

/// How many of `count` repetitions a test that loops over seeded cases is to run: all of them in an optimised build, a
/// tenth where assertions or sanitizers slow them down. The environment variable MESHER_TEST_EFFORT multiplies either
/// (a number, e.g. 10 for a nightly run, 0.1 for a quick one). At least one.
inline int repetitions(int count)
{
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
    double effort = 1.0;
#else
    double effort = 0.1;
#endif
    if (const char* factor = std::getenv("MESHER_TEST_EFFORT")) effort *= std::atof(factor);
    const int scaled = static_cast<int>(count * effort);
    return scaled < 1 ? 1 : scaled;
}

}  // namespace mesher::test
