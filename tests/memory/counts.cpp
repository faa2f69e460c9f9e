#include "memory/counts.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace carom::test {

MemoryCounts memory_counts;

}  // namespace carom::test

namespace {

void* counted(void* block) {
    if (!block) throw std::bad_alloc();
    carom::test::MemoryCounts& counts = carom::test::memory_counts;
    ++counts.allocations;
    counts.bytes += malloc_usable_size(block);
    counts.most_bytes = std::max(counts.most_bytes, counts.bytes);
    return block;
}

void give_back(void* block) {
    carom::test::memory_counts.bytes -= malloc_usable_size(block);
    std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(std::malloc(size == 0 ? 1 : size));
}
void* operator new[](std::size_t size) {
    return counted(std::malloc(size == 0 ? 1 : size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto step = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* block, std::align_val_t) noexcept {
    give_back(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    give_back(block);
}
void operator delete(void* block) noexcept {
    give_back(block);
}
void operator delete[](void* block) noexcept {
    give_back(block);
}
void operator delete(void* block, std::size_t) noexcept {
    give_back(block);
}
void operator delete[](void* block, std::size_t) noexcept {
    give_back(block);
}
