#include "heap.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace carom::bench {
namespace {

std::size_t taken = 0;

}  // namespace

std::size_t heap_bytes() {
    return taken;
}

namespace {

void* counted(void* block) {
    if (!block) throw std::bad_alloc();
    taken += malloc_usable_size(block);
    return block;
}

void* take(std::size_t size) {
    return counted(std::malloc(size == 0 ? 1 : size));
}

void* take(std::size_t size, std::align_val_t alignment) {
    const std::size_t step = std::max(static_cast<std::size_t>(alignment), sizeof(void*));
    return counted(
        std::aligned_alloc(step, std::max((size + step - 1) / step, std::size_t{1}) * step));
}

void give_back(void* block) {
    if (block) taken -= malloc_usable_size(block);
    std::free(block);
}

}  // namespace
}  // namespace carom::bench

void* operator new(std::size_t size) {
    return carom::bench::take(size);
}
void* operator new[](std::size_t size) {
    return carom::bench::take(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return carom::bench::take(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return carom::bench::take(size, alignment);
}
void operator delete(void* block) noexcept {
    carom::bench::give_back(block);
}
void operator delete[](void* block) noexcept {
    carom::bench::give_back(block);
}
void operator delete(void* block, std::size_t) noexcept {
    carom::bench::give_back(block);
}
void operator delete[](void* block, std::size_t) noexcept {
    carom::bench::give_back(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    carom::bench::give_back(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
    carom::bench::give_back(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    carom::bench::give_back(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
    carom::bench::give_back(block);
}
