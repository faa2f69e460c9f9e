#include "carom/text/level_words.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace carom {
namespace {

/// A line this long continues in the next one.
constexpr std::size_t full_line = 60;
/// The longest text before the blanks of an entry.
constexpr std::size_t longest_left = 30;
constexpr std::string_view goal_mark = "Goal:";

std::string without_quotes(std::string_view text) {
    std::string plain(text);
    std::erase(plain, '`');
    return plain;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t from = std::min(text.find_first_not_of(' '), text.size());
    const std::size_t last = text.find_last_not_of(' ');
    return last == text.npos ? std::string_view{} : text.substr(from, last + 1 - from);
}

/// "  KEYS   meaning" as an entry; none: the line is not one.
std::optional<LevelWords::Item> entry_of(std::string_view line) {
    const std::string_view text = trimmed(line);
    const std::size_t blanks = text.find("  ");
    if (!line.starts_with("  ") || blanks == text.npos || blanks > longest_left)
        return std::nullopt;
    return LevelWords::Item{without_quotes(text.substr(0, blanks)),
                            without_quotes(trimmed(text.substr(blanks)))};
}

}  // namespace

LevelWords words_of(std::span<const std::string> comment) {
    LevelWords words;
    bool continues = false;  // the next line belongs to the last item
    bool is_goal = false;
    for (const std::string& line : comment) {
        const std::string_view text = trimmed(line);
        if (text.empty()) {
            if (!words.items.empty() && !is_goal) words.items.push_back({});
            continues = is_goal = false;
            continue;
        }
        if (text.starts_with(goal_mark)) {
            words.goal = without_quotes(trimmed(text.substr(goal_mark.size())));
            is_goal = true;
            continue;
        }
        if (is_goal) {
            words.goal += " " + without_quotes(text);
            continue;
        }
        const bool is_indented = line.starts_with("  ");
        const bool is_in_list = continues && !words.items.back().left.empty();
        if (auto entry = entry_of(line)) {
            words.items.push_back(std::move(*entry));
            continues = true;
        } else if (continues && is_indented == is_in_list) {
            words.items.back().text += " " + without_quotes(text);
            continues = is_in_list || line.size() >= full_line;
        } else {
            words.items.push_back({"", without_quotes(text)});
            continues = !is_indented && line.size() >= full_line;
        }
    }
    while (!words.items.empty() && words.items.back().left.empty() &&
           words.items.back().text.empty())
        words.items.pop_back();
    return words;
}

}  // namespace carom
