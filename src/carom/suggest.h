#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace carom {

/// The one of `candidates` that was probably meant by `typed`: at most a third of its letters (and
/// at least one) wrong, missing, added or swapped with their neighbour. None when none is that
/// near. Of those equally near, the first.
std::optional<std::string> nearest(std::string_view typed, std::span<const std::string> candidates);

/// "; did you mean 'NAME'?", or nothing.
std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates);

}  // namespace carom
