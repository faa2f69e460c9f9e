#include "physics/memory/large_pages.h"

#include <doctest/doctest.h>
#include <cstdint>

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
