#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "carom/context/action.h"

/// The help pages: for each way of playing, the keys that matter there, on one page. One table
/// holds all lines (carom/controllers/help_pages.cpp); KeyMap::help adds the keys that are bound.
namespace carom {

/// The ways of playing. `cue`: with a cue, and without a referee of pool.
enum class PlayKind : std::uint8_t { free, pool, cue, pinball, watching };

constexpr std::uint8_t help_bit(PlayKind kind) {
    return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
}

struct HelpLine {
    std::uint8_t pages;  ///< help_bit() of each way of playing that shows the line
    std::string_view section;
    /// Names of the actions that share the line, separated by blanks; empty: a line for the mouse.
    /// The line is left out while none of them has a key.
    std::string_view actions;
    /// Shown while all of them have their default keys; empty: the first key of each.
    std::string_view keys;
    std::string_view help;
};

/// Words for the line of these actions in the game that is played; without words it has no line.
struct HelpWords {
    std::string_view actions;
    std::string_view help;
};

/// In the order of the pages. Lines of a section stand together on each page.
std::span<const HelpLine> help_lines();

/// A line, in a last section, for each of the actions that help_lines() does not name: its own
/// help, where it applies. So an action is on the help pages as soon as it is in the table of
/// actions.
std::vector<HelpLine> unnamed_lines(std::span<const Action> actions);

}  // namespace carom
