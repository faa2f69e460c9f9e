#include "physics/memory/large_pages.h"

#include <doctest/doctest.h>
#include <cstdint>
#include <new>

using namespace carom;

TEST_CASE("an array keeps its contents while it grows into large pages and shrinks out of them") {
    LargeVector<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < 1'000'000; ++i)
        numbers.push_back(i);
    CHECK(reinterpret_cast<std::uintptr_t>(numbers.data()) % (2u << 20) == 0);
    numbers.resize(1000);
    numbers.shrink_to_fit();
    const LargeVector<std::uint64_t> copy = numbers;
    CHECK(copy.size() == 1000);
    for (std::uint64_t i = 0; i < copy.size(); ++i)
        CHECK(copy[i] == i);
}

TEST_CASE("a small array has the alignment of its type") {
    struct alignas(128) DoubleDouble {
        char content[128];
    };
    for (std::size_t count = 1; count < 50; ++count) {
        const LargeVector<DoubleDouble> wide(count);
        CHECK(reinterpret_cast<std::uintptr_t>(wide.data()) % 128 == 0);
    }
}

TEST_CASE("large pages are one after another, and can be written from end to end") {
    for (const std::size_t bytes : {large_page, large_page + 1, 3 * large_page - 1}) {
        auto* const start = static_cast<unsigned char*>(map_large_pages(bytes));
        CHECK(reinterpret_cast<std::uintptr_t>(start) % large_page == 0);
        CHECK(start[0] == 0);
        start[bytes - 1] = 1;
        CHECK(start[bytes - 1] == 1);
        unmap_large_pages(start, bytes);
    }
    CHECK_THROWS_AS(map_large_pages(~std::size_t{0}), std::bad_alloc);
}
