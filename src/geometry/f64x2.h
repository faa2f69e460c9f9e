#pragma once

#include <bit>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/// Two doubles in one SIMD register. Each lane computes with the operations of a single double, and
/// so gives its bits. On machines without such registers the compiler computes lane by lane.
namespace carom {

using F64x2 = double __attribute__((vector_size(16)));
using U64x2 = std::uint64_t __attribute__((vector_size(16)));

/// std::max(value, least) in each lane, with std::max's result for NaN.
inline F64x2 at_least(F64x2 least, F64x2 value) {
    return value < least ? least : value;
}

/// std::min(value, most) in each lane, with std::min's result for NaN.
inline F64x2 at_most(F64x2 most, F64x2 value) {
    return most < value ? most : value;
}

/// The 64-bit products of the lower 32 bits of each lane.
inline U64x2 low_products(U64x2 a, U64x2 b) {
#ifdef __SSE2__
    // g++ takes three multiplications for the portable form below.
    return std::bit_cast<U64x2>(
        _mm_mul_epu32(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#else
    constexpr std::uint64_t low = 0xffffffffu;
    return (a & low) * (b & low);
#endif
}

/// Another name of U64x2, in physics/world/same_bits.h.
using TwoBits = U64x2;

}  // namespace carom
