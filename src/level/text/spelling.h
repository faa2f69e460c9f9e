#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Suggestions for misspelt words: "did you mean".
namespace carom {

/// The edit distance of two words (optimal string alignment): the fewest insertions, deletions,
/// replacements and swaps of neighbouring letters that turn one into the other. O(|a| |b|).
int edit_distance(std::string_view a, std::string_view b);

/// Only the first of this many candidates are compared.
inline constexpr std::size_t max_candidates = 1000;

/// The candidate with the lowest edit distance to `word`, the first in a tie. None: all distances
/// exceed a third of its letters (and 1).
std::optional<std::string_view> nearest_word(std::string_view word,
                                             const std::vector<std::string_view>& candidates);

/// "did you mean 'bumper'?", or `otherwise` if nothing is similar.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates,
                         std::string otherwise);

}  // namespace carom
