#pragma once

#include <string_view>

namespace carom {

/// Of this carom, such as "0.1.0".
std::string_view version();

}  // namespace carom
