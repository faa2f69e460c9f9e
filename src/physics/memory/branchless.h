#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

/// Choices without a branch, where no processor can predict them: a mispredicted branch costs about
/// twenty instructions.
namespace carom {

/// The first number or the second.
inline std::uint32_t select(bool is_first, std::uint32_t first, std::uint32_t second) {
    const std::uint32_t mask = 0u - static_cast<std::uint32_t>(is_first);
    return (first & mask) | (second & ~mask);
}

/// Assigns `from` to `to` if `is_so`.
template <typename Value>
inline void assign_if(bool is_so, Value& to, const Value& from) {
    static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % 8 == 0);
    const std::uint64_t mask = std::uint64_t{0} - static_cast<std::uint64_t>(is_so);
    std::array<std::uint64_t, sizeof(Value) / 8> old;
    std::array<std::uint64_t, sizeof(Value) / 8> other;
    std::memcpy(&old, &to, sizeof(Value));
    std::memcpy(&other, &from, sizeof(Value));
    for (std::size_t i = 0; i < old.size(); ++i)
        old[i] ^= (old[i] ^ other[i]) & mask;
    std::memcpy(static_cast<void*>(&to), &old, sizeof(Value));
}

}  // namespace carom
