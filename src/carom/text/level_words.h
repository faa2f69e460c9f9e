#pragma once

#include <span>
#include <string>
#include <vector>

/// The opening comment of a level, as text for the player: paragraphs, lists, and its goal.
///
/// Authors write for an editor's window; what they write is laid out again for the terminal's:
///   - lines of a paragraph are joined, if they are as long as an editor's window is wide;
///   - a paragraph that starts with "Goal:" is the goal, one sentence about what to do;
///   - an indented line with a run of blanks within is an entry of a list: what stands before the
///     blanks ("e", "right-drag") and its meaning. Deeper indented lines continue it.
///   - other indented lines stay lines of their own.
/// Backquotes are left out.
namespace carom {

struct LevelWords {
    struct Item {
        std::string left;  ///< of an entry; empty for a paragraph
        std::string text;  ///< both empty: a blank line
    };
    std::string goal;         ///< without "Goal:"; empty: the comment names none
    std::vector<Item> items;  ///< without the goal
};

LevelWords words_of(std::span<const std::string> comment);

}  // namespace carom
