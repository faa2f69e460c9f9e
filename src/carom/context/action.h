#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "game/commands/command.h"

/// Actions: everything that a key can do. One table holds them all
/// (carom/controllers/action_table.cpp). Key dispatch, hints, preferences and the list in
/// docs/command-line.md follow from it, so a new key command is one row there and one line in that
/// list. The help pages show its own help until help_pages.cpp has better words for it.
namespace carom {

struct PlayContext;
class PoolController;
class PinballController;

/// Where an action applies.
enum class Where : std::uint8_t {
    anywhere,
    playing,  ///< not while a recording is watched
    editing,  ///< changes the scene: not while a recording is watched, nor in a game of pinball
    pool,     ///< at pool tables
    pinball   ///< at pinball tables
};

struct Action {
    /// The effect of the action. A Button of a pinball table is pressed while its key is held.
    using Perform = std::variant<void (*)(PlayContext&), void (*)(PoolController&, PlayContext&),
                                 void (*)(PinballController&, PlayContext&), Button>;
    /// The effect at a pool table instead. False: it does not apply now, so `perform` is called.
    using AtPool = bool (*)(PoolController&, PlayContext&);

    std::string_view name;  ///< stored in the preferences file, so it never changes
    std::string_view
        keys;  ///< the default keys, in the syntax of the preferences file, separated by blanks
    /// In docs/command-line.md, and on the help pages where these have no words of their own.
    std::string_view help;
    Where where;
    Perform perform;
    AtPool at_pool = nullptr;
};

/// The layers of the key map: within a layer, a key has at most one action. At a pinball table, a
/// key of `pinball` takes precedence over the same key of `common`.
enum class KeyLayer : std::uint8_t { common, pinball };
inline KeyLayer layer_of(const Action& action) {
    return action.where == Where::pinball ? KeyLayer::pinball : KeyLayer::common;
}

/// All actions, in the order of the manual.
std::span<const Action> actions();
/// The action of this name; null if there is none.
const Action* action_named(std::string_view name);
/// Pre: there is an action of this name.
const Action& action(std::string_view name);
std::vector<std::string_view> action_names();

}  // namespace carom
