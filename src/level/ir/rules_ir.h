#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "level/scene/rules.h"
#include "level/text/words.h"

/// The rules of a level in the intermediate representation (level_ir.h): their names are not
/// resolved.
namespace carom {

/// A name in a rule, and what it may denote.
struct RuleNameIr {
    enum class Role : std::uint8_t {
        lights,    ///< devices that have lights, or are lit while they are open or hold a ball
        switched,  ///< devices whose lights rules switch
        opening,   ///< gates and posts
        holder,    ///< holes and magnets
        balls,     ///< a ball, a rack, a kind, or `ball`, `cue`, `opponent`
        place,     ///< a pocket or a zone
        device     ///< a part of a pinball table
    };
    Word word;
    Role role = Role::lights;
};

/// A rule with unresolved names. Where the rule has the index of a device group, of balls or of a
/// place, it is an index into `names` until assembly replaces it.
struct RuleIr {
    Rule rule;
    Word subject;
    Word event;
    std::optional<Word> other;
    std::vector<RuleNameIr> names;
    Word needs;                 ///< the first word of its conditions; else its event
    std::vector<Word> actions;  ///< the word of each of the rule's actions
};

/// A line of `task` or `goal`, like a rule without an event.
struct TaskIr {
    Word text;
    RuleTask task;
    std::vector<RuleNameIr> names;
};
struct GoalIr {
    Word text;
    LevelGoal goal;
    std::vector<RuleNameIr> names;
};

/// A variable or a timer of the rules, and whether a rule reads it.
struct RuleSymbolIr {
    Word name;
    bool is_timer = false;
    std::uint32_t index = 0;  ///< into LevelIr::variables or timers
    bool is_read = false;
};

}  // namespace carom
