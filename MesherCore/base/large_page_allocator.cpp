#include "base/large_page_allocator.h"

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace mesher::detail {

void* allocateLargePages(std::size_t bytes)
{
    constexpr std::size_t kLargePage = std::size_t{2} << 20;
    const std::size_t rounded = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    void* memory = std::aligned_alloc(kLargePage, rounded);
    if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    // A hint only: a refusal leaves ordinary pages, which is slower and just as good.
    static_cast<void>(madvise(memory, rounded, MADV_HUGEPAGE));
#endif
    return memory;
}

void freeLargePages(void* memory) noexcept
{
    std::free(memory);
}

}  // namespace mesher::detail
