#pragma once

#include <cstddef>
#include <new>
#include <vector>

/// Memory in large pages, for large arrays that are read at random: with small pages, address
/// translation would take as long as the read itself.
namespace carom {

/// Asks the system to back these bytes with large pages. Only speed depends on whether it does.
/// Pre: `start` is aligned to a large page (2 MB).
void ask_for_large_pages(void* start, std::size_t bytes);

/// An allocator that does so for arrays of at least 2 MB; smaller ones come from operator new.
template <typename T>
class LargePages {
  public:
    using value_type = T;

    LargePages() = default;
    template <typename Other>
    LargePages(const LargePages<Other>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < least) return static_cast<T*>(::operator new(bytes, small_alignment()));
        void* const start = ::operator new(bytes, page);
        ask_for_large_pages(start, bytes);
        return static_cast<T*>(start);
    }
    void deallocate(T* start, std::size_t count) {
        ::operator delete(start, count * sizeof(T) < least ? small_alignment() : page);
    }

    friend bool operator==(const LargePages&, const LargePages&) { return true; }

  private:
    static constexpr std::size_t least = std::size_t{2} << 20;  ///< bytes: one large page
    static constexpr std::align_val_t page{std::size_t{2} << 20};
    static constexpr std::align_val_t small_alignment() { return std::align_val_t{alignof(T)}; }
};

template <typename T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace carom
