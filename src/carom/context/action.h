#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "game/commands/command.h"

/// Actions: everything that a key can do. One table holds them all
/// (carom/controllers/action_table.cpp). The dispatch of keys, the help page, the hints, the
/// preferences and the list in docs/command-line.md follow from it, so a new key command is one row
/// there and one line in that list.
namespace carom {

struct PlayContext;
class PoolController;
class PinballController;

/// Where an action applies.
enum class Where : std::uint8_t {
    anywhere,
    playing,  ///< not while a recording is watched
    pool,     ///< at pool tables
    pinball   ///< at pinball tables
};

struct Action {
    /// What the action does. A Button of a pinball table is pressed while its key is held.
    using Perform = std::variant<void (*)(PlayContext&), void (*)(PoolController&, PlayContext&),
                                 void (*)(PinballController&, PlayContext&), Button>;
    /// What it does instead at a pool table. False: nothing now, so `perform` is to be done.
    using AtPool = bool (*)(PoolController&, PlayContext&);

    std::string_view name;     ///< in the preferences file, so it never changes
    std::string_view keys;     ///< the default keys, as in the preferences file, blanks between
    std::string_view help;     ///< on the help page
    std::string_view section;  ///< of the help page
    Where where;
    Perform perform;
    AtPool at_pool = nullptr;
};

/// The sets of actions among which a key does one thing at most. At a pinball table a key of
/// `pinball` comes before the same key of `common`.
enum class KeyLayer : std::uint8_t { common, pinball };
inline KeyLayer layer_of(const Action& action) {
    return action.where == Where::pinball ? KeyLayer::pinball : KeyLayer::common;
}

/// All actions, in the order of the help page.
std::span<const Action> actions();
/// Null: there is no action of this name.
const Action* action_named(std::string_view name);
/// Pre: there is an action of this name.
const Action& action(std::string_view name);
std::vector<std::string_view> action_names();

/// Several actions that the help page shows as one line, as long as all have their default keys.
struct ActionGroup {
    std::string_view first;  ///< name of the first action
    std::string_view last;   ///< name of the last action; those between belong to it too
    std::string_view keys;
    std::string_view help;
};
std::span<const ActionGroup> action_groups();

/// A line of the help page that is no action of its own: the mouse, or what an action means in
/// another section.
struct HelpNote {
    std::string_view section;
    std::string_view after;   ///< the section behind which its section stands, where it has no rows
    std::string_view keys;    ///< empty: those of `action`
    std::string_view action;  ///< name
    std::string_view help;
};
std::span<const HelpNote> help_notes();

}  // namespace carom
