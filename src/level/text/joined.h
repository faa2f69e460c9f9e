#pragma once

#include <span>
#include <string>
#include <string_view>

namespace carom {

/// The words in a row, with `separator` between them. In place of fmt::join, which makes each unit
/// that uses it compile the formatting of ranges.
std::string joined(std::span<const std::string> words, std::string_view separator);
std::string joined(std::span<const std::string_view> words, std::string_view separator);

}  // namespace carom
