#pragma once

#include <bit>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/// Two numbers that are computed side by side, each by the operations that a double alone would go
/// through, and so with its bits. What the machine has no such operations for, the compiler takes
/// one by one.
namespace carom {

using Two = double __attribute__((vector_size(16)));
using TwoBits = std::uint64_t __attribute__((vector_size(16)));

/// std::max(value, least), by std's rule for what compares as neither.
inline Two at_least(Two least, Two value) {
    return value < least ? least : value;
}

/// std::min(value, most).
inline Two at_most(Two most, Two value) {
    return most < value ? most : value;
}

/// The products of their lower halves.
inline TwoBits low_products(TwoBits a, TwoBits b) {
#ifdef __SSE2__
    // Written as below, g++ takes three multiplications for it.
    return std::bit_cast<TwoBits>(
        _mm_mul_epu32(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#else
    constexpr std::uint64_t low = 0xffffffffu;
    return (a & low) * (b & low);
#endif
}

}  // namespace carom
