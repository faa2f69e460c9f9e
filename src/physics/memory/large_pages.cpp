#include "physics/memory/large_pages.h"

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#include <limits>
#endif

namespace carom {

#ifdef __linux__

namespace {

// munmap takes whole pages of the system; their size divides this.
std::size_t in_pages(std::size_t bytes) {
    constexpr std::size_t page = std::size_t{64} << 10;
    return (bytes + page - 1) / page * page;
}

}  // namespace

// Maps a large page more than is needed, and gives back what lies before the first boundary and
// behind the end.
void* map_large_pages(std::size_t bytes) {
    if (bytes > std::numeric_limits<std::size_t>::max() / 2) throw std::bad_alloc();
    const std::size_t needed = in_pages(bytes);
    void* const all = mmap(nullptr, needed + large_page, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(all);
    const std::size_t before =
        (large_page - reinterpret_cast<std::uintptr_t>(all) % large_page) % large_page;
    char* const start = begin + before;
    if (before > 0) munmap(begin, before);
    if (before < large_page) munmap(start + needed, large_page - before);
    madvise(start, needed, MADV_HUGEPAGE);  // a refusal is ignored
    return start;
}

void unmap_large_pages(void* start, std::size_t bytes) noexcept {
    munmap(start, in_pages(bytes));
}

#else

void* map_large_pages(std::size_t bytes) {
    return ::operator new (bytes, std::align_val_t{large_page});
}

void unmap_large_pages(void* start, std::size_t) noexcept {
    ::operator delete (start, std::align_val_t{large_page});
}

#endif

}  // namespace carom
