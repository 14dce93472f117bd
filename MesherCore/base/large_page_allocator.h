#pragma once

#include <cstddef>
#include <new>

namespace mesher {

namespace detail {

/// Memory for a large array, on large pages where the system lends them: a walk through a mesh touches memory far apart,
/// and with small pages the address translation costs as much as the fetch.
[[nodiscard]] void* allocateLargePages(std::size_t bytes);
void freeLargePages(void* memory) noexcept;

/// From here on an array is large; below, the ordinary allocator wastes less.
inline constexpr std::size_t kLargeArrayBytes = std::size_t{8} << 20;

}  // namespace detail

/// The standard allocator, but for large arrays on large pages.
template <class T>
class LargePageAllocator
{
public:
    using value_type = T;

    LargePageAllocator() = default;
    template <class U>
    constexpr LargePageAllocator(const LargePageAllocator<U>&) noexcept
    {
    }

    [[nodiscard]] T* allocate(std::size_t count)
    {
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = count * sizeof(T);
        if (bytes >= detail::kLargeArrayBytes) return static_cast<T*>(detail::allocateLargePages(bytes));
        return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
    }
    void deallocate(T* memory, std::size_t count) noexcept
    {
        if (count * sizeof(T) >= detail::kLargeArrayBytes) {
            detail::freeLargePages(memory);
        } else {
            ::operator delete(memory, std::align_val_t(alignof(T)));
        }
    }

    template <class U>
    friend constexpr bool operator==(const LargePageAllocator&, const LargePageAllocator<U>&)
    {
        return true;
    }
};

}  // namespace mesher
