#pragma once

#include <cstddef>

namespace carom {

/// From this many balls on, their data does not fit into the nearest caches, and prefetching pays.
inline constexpr std::size_t too_many_to_cache = 8192;

/// Prefetches the cache line at `address`, without waiting for it.
inline void prefetch_line(const void* address) {
    __builtin_prefetch(address);
    // Keeps the call: g++ regards functions that do nothing but prefetch as empty.
    asm volatile("");
}

}  // namespace carom
