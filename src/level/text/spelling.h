#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// "did you mean": the nearest of the words that would have been right.
namespace carom {

/// Letters to insert, drop, change or swap with their neighbour to turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// More candidates than these are not looked at.
inline constexpr std::size_t max_candidates = 1000;

/// The candidate nearest to `word`, if no further than a third of its letters (at least one); the
/// first of equals.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             const std::vector<std::string_view>& candidates);

/// "did you mean 'bumper'?", or `otherwise` when nothing is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates,
                         std::string otherwise);

}  // namespace carom
