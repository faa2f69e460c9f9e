#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace carom {

/// 1, 2, 3, 4, 6, 8, 12, 16, 24 ... and `last`: points about evenly spread on a logarithmic scale.
/// `extra` is included if it is from 1 to `last`. Empty for `last` 0.
std::vector<std::uint64_t> spread(std::uint64_t last, std::optional<std::uint64_t> extra = {});

}  // namespace carom
