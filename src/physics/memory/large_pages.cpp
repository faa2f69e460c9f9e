#include "physics/memory/large_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace carom {

// A refusal is ignored: without large pages everything works, only slower.
void ask_for_large_pages([[maybe_unused]] void* start, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    madvise(start, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace carom
