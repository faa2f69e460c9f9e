#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// The end of a sentence about a mistyped word: "; did you mean 'NAME'?", or empty if no candidate
/// is similar.
std::string suggestion(std::string_view typed, const std::vector<std::string_view>& candidates);

}  // namespace carom
