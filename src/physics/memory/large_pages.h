#pragma once

#include <cstddef>
#include <new>
#include <vector>

/// Memory in large pages, for large arrays that are read at random: with small pages, address
/// translation would take as long as the read itself.
namespace carom {

/// Memory of its own from the system, which backs it with large pages if it can: only speed depends
/// on that. It begins at a multiple of large_page and costs no address space beyond `bytes`.
/// Memory that is given back leaves the process at once. On the heap, free places between aligned
/// blocks are often too short for the next one, so a heap of aligned blocks grows without bound.
///
/// Throws std::bad_alloc if the system has none left. Pre: bytes > 0.
void* map_large_pages(std::size_t bytes);
/// Gives it back. Pre: `start` is from map_large_pages(bytes).
void unmap_large_pages(void* start, std::size_t bytes) noexcept;

inline constexpr std::size_t large_page = std::size_t{2} << 20;  ///< bytes

/// An allocator that takes arrays of at least a large page from there; smaller ones come from
/// operator new.
template <typename T>
class LargePages {
  public:
    using value_type = T;

    LargePages() = default;
    template <typename Other>
    LargePages(const LargePages<Other>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        return static_cast<T*>(bytes < large_page ? ::operator new(bytes, small_alignment())
                                                  : map_large_pages(bytes));
    }
    void deallocate(T* start, std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < large_page)
            ::operator delete(start, small_alignment());
        else
            unmap_large_pages(start, bytes);
    }

    friend bool operator==(const LargePages&, const LargePages&) { return true; }

  private:
    static constexpr std::align_val_t small_alignment() { return std::align_val_t{alignof(T)}; }
};

template <typename T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace carom
