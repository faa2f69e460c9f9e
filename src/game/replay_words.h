#pragma once

#include <string_view>

namespace carom {

/// How replay texts say Side, by its value.
inline constexpr std::string_view side_names[] = {"both", "left", "right"};

}  // namespace carom
