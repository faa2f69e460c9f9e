#include "heap.h"

#include <malloc.h>

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

void* take(std::size_t size) {
    void* block = std::malloc(size == 0 ? 1 : size);
    if (!block) throw std::bad_alloc();
    taken += malloc_usable_size(block);
    return block;
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
