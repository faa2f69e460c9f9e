#pragma once

/// Two doubles in one SIMD register. Each lane computes exactly what a single double would, with
/// the same bits. On machines without such registers the compiler computes lane by lane.
namespace carom {

using F64x2 = double __attribute__((vector_size(16)));

/// std::max(value, least) in each lane, including std::max's result for NaN.
inline F64x2 at_least(F64x2 least, F64x2 value) {
    return value < least ? least : value;
}

/// std::min(value, most) in each lane, including std::min's result for NaN.
inline F64x2 at_most(F64x2 most, F64x2 value) {
    return most < value ? most : value;
}

}  // namespace carom
