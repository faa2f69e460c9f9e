#pragma once

#include <cstddef>

namespace carom::test {

/// What operator new has given: this program replaces it (counts.cpp).
struct MemoryCounts {
    std::size_t allocations = 0;
    std::size_t bytes = 0;       ///< not yet given back
    std::size_t most_bytes = 0;  ///< the most at any time since it was last set
};
extern MemoryCounts memory_counts;

}  // namespace carom::test
