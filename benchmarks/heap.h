#pragma once

#include <cstddef>

/// What the process has taken from the heap. To link it is to count: `operator new` is replaced.
namespace carom::bench {

/// Bytes that are taken now, as the allocator rounds them.
std::size_t heap_bytes();

}  // namespace carom::bench
