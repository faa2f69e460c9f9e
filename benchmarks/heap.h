#pragma once

#include <cstddef>

/// The heap memory of this process. Linking this file replaces `operator new` by one that counts.
namespace carom::bench {

/// Bytes allocated now, as the allocator rounds them.
std::size_t heap_bytes();

}  // namespace carom::bench
