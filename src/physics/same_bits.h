#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

namespace carom {

/// Bit by bit, which takes a small part of the time of a comparison by numbers. Pre: no bytes of a
/// Value are padding.
template <typename Value>
bool have_same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

}  // namespace carom
