// Big tables that rays read at random: in pages of 2 MiB where the system has them. With pages of
// 4 KiB nearly every look-up also misses the address translation, which in a virtual machine takes
// longer than the look-up itself.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gp {

template <class T>
struct LargePages {
    using value_type = T;
    static constexpr size_t pageBytes = size_t(2) << 20;

    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) noexcept {}

    T* allocate(size_t n) {
        const size_t bytes = n * sizeof(T), whole = bytes / pageBytes * pageBytes;
        const size_t alignment = whole ? pageBytes : alignof(std::max_align_t);
        void* p = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
        if (!p) throw std::bad_alloc();
#if defined(__linux__)
        // Of the last page only what is touched should count: it stays in small ones.
        if (whole) madvise(p, whole, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(p);
    }
    void deallocate(T* p, size_t) noexcept { std::free(p); }

    // Elements made without a value keep what the memory holds: their owner fills them at once.
    template <class U, class... Arguments>
    void construct(U* p, Arguments&&... arguments) {
        if constexpr (sizeof...(Arguments) == 0)
            ::new (static_cast<void*>(p)) U;
        else
            ::new (static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
    }

    bool operator==(const LargePages&) const { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace gp
