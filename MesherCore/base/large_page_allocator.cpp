#include "base/large_page_allocator.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace mesher::detail {

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;

}  // namespace

void* allocateLargePages(std::size_t bytes)
{
    void* memory = ::operator new(bytes, std::align_val_t(kLargePage));
#if defined(__linux__)
    // A hint only: a refusal leaves ordinary pages, which is slower and just as good.
    static_cast<void>(madvise(memory, bytes / kLargePage * kLargePage, MADV_HUGEPAGE));
#endif
    return memory;
}

void freeLargePages(void* memory) noexcept { ::operator delete(memory, std::align_val_t(kLargePage)); }

}  // namespace mesher::detail
