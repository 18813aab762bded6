// Big tables that rays read at random: in pages of 2 MiB where the system has them. With pages of
// 4 KiB nearly every look-up also misses the address translation, which in a virtual machine takes
// longer than the look-up itself. They are mapped by themselves: in the heap nobody would get back
// the holes around what is aligned to 2 MiB.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>
#include <vector>

// The sanitizer sees what is wrong with blocks of the heap only.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#include <sys/mman.h>
#define GP_MAPS_PAGES
#endif

namespace gp {

constexpr size_t largePageBytes = size_t(2) << 20;

#if defined(GP_MAPS_PAGES)
// Aligned to large pages, which it asks for; of the last one only what is touched counts, since
// that stays in small ones. Null: there is no memory.
inline void* mapLargePages(size_t bytes) {
    const size_t reserved = bytes + largePageBytes;
    void* all = mmap(nullptr, reserved, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) return nullptr;
    char* first = static_cast<char*>(all);
    void* aligned = all;
    size_t space = reserved;
    std::align(largePageBytes, bytes, aligned, space);
    char* begin = static_cast<char*>(aligned);
    char* end = begin + (bytes + 4095) / 4096 * 4096;
    if (begin > first) munmap(first, size_t(begin - first));
    if (end < first + reserved) munmap(end, size_t(first + reserved - end));
    madvise(begin, bytes / largePageBytes * largePageBytes, MADV_HUGEPAGE);
    return begin;
}
#endif

template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) noexcept {}

    T* allocate(size_t n) {
        void* p = nullptr;
#if defined(GP_MAPS_PAGES)
        p = isLarge(n) ? mapLargePages(n * sizeof(T)) : std::malloc(n * sizeof(T));
#else
        p = std::malloc(n * sizeof(T));
#endif
        if (!p) throw std::bad_alloc();
        return static_cast<T*>(p);
    }
    void deallocate(T* p, [[maybe_unused]] size_t n) noexcept {
#if defined(GP_MAPS_PAGES)
        if (isLarge(n)) {
            munmap(p, n * sizeof(T));  // the system rounds up to its pages
            return;
        }
#endif
        std::free(p);
    }
    static constexpr bool isLarge(size_t n) { return n * sizeof(T) >= largePageBytes; }

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
