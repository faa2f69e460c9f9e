#pragma once

#include <cstddef>
#include <iterator>
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

/// The candidate that `word` is another usual name of, as "radius" of "r"; none: it is of none.
std::optional<std::string_view> meant_by(std::string_view word,
                                         const std::vector<std::string_view>& candidates);

/// The candidate that `word` is another usual name of, as "radius" of "r"; else the one that
/// differs from it in upper and lower case only; else the one with the lowest edit distance to it,
/// the first in a tie. None: all distances exceed a third of its letters (and 1).
std::optional<std::string_view> nearest_word(std::string_view word,
                                             const std::vector<std::string_view>& candidates);

/// "did you mean 'bumper'?", or `otherwise` if nothing is similar.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates,
                         std::string otherwise);

/// The row of a table with this name, or null: there is none. Rows have a member `name`.
template <typename Rows>
auto row_named(const Rows& rows, std::string_view name) {
    for (const auto& row : rows)
        if (row.name == name) return &row;
    return decltype(&*std::begin(rows)){};
}

/// The names of all rows, as candidates.
template <typename Rows>
std::vector<std::string_view> names_of(const Rows& rows) {
    std::vector<std::string_view> names;
    for (const auto& row : rows)
        names.push_back(row.name);
    return names;
}

}  // namespace carom
