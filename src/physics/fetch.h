#pragma once

#include <cstdint>

namespace carom {

/// Fetches the line of memory at `address` into the cache, and does not wait for it.
inline void fetch_early(const void* address) {
    __builtin_prefetch(address);
    // g++ takes functions that do nothing but this to do nothing, and leaves out the calls.
    asm volatile("");
}

/// One of two numbers, without a branch: for where nobody can foretell which, and a wrong guess of
/// the processor takes as long as some twenty instructions.
inline std::uint32_t select(bool is_first, std::uint32_t first, std::uint32_t second) {
    const std::uint32_t mask = 0u - static_cast<std::uint32_t>(is_first);
    return (first & mask) | (second & ~mask);
}

}  // namespace carom
