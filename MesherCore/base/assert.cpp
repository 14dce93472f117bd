#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace mesher::detail {

void assertionFailed(const char* kind, const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "%s:%d: broken %s: %s\n", file, line, kind, condition);
    std::abort();
}

}  // namespace mesher::detail
