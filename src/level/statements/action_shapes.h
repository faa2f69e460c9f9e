#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "level/scene/rules.h"

/// The table of the actions of rules: what follows the name of each, in which games it works, and
/// what it does. The reader (rule_actions.h), messages and `carom explain on` use it.
namespace carom {

/// What follows the name of an action. Those with `maybe` may lack their last word.
enum class Takes : std::uint8_t {
    nothing,
    points,
    sum,    ///< +N adds, N sets
    count,  ///< 1 or more
    time,
    lights,
    lights_and_maybe_time,
    opening,
    opening_and_maybe_time,
    holder,
    timer,
    timer_and_maybe_time,
    balls_and_maybe_place,
    balls_and_maybe_side,
    maybe_place,
    text
};

struct ActionShape {
    std::string_view name;
    RuleAction::What what;
    Takes takes;
    RuleGames games;
    std::string_view sample;
    std::string_view does;  ///< in one line
    double most = 1e12;     ///< of a number that has no variable
};

/// One row for each action but that of variables.
std::span<const ActionShape> action_shapes();
/// VARIABLE +1: `name` is no word of the language.
const ActionShape& variable_shape();
/// The row of an action, motions being started and stopped as timers are.
const ActionShape& action_shape_of(RuleAction::What what);

/// How many words an action has, with its name.
struct WordCounts {
    std::size_t least = 1;
    std::size_t most = 1;
};
WordCounts words_of(Takes takes);

}  // namespace carom
