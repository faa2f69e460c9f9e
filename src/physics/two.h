#pragma once

#include <cstdint>

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

}  // namespace carom
