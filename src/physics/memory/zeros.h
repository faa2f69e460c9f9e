#pragma once

#include <cstddef>
#include <vector>

namespace carom {

/// `count` zeros. Unlike `numbers.assign(count, 0)`, which a compiler shares with other values,
/// this calls memset.
template <typename Number>
void assign_zeros(std::vector<Number>& numbers, std::size_t count) {
    numbers.clear();
    numbers.resize(count);
}

}  // namespace carom
