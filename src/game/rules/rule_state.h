#pragma once

#include <cstdint>
#include <vector>

#include "level/scene/rules.h"

namespace carom {

/// What the rules of a level remember, besides the game and the world. Plain state: a copy together
/// with copies of these continues with the same bits. Times are in ticks.
struct RuleState {
    /// By RuleBook::variables; a player's variable has a value for each player, in turn.
    std::vector<std::int64_t> values;
    std::vector<std::uint64_t> timer_ends;  ///< by RuleBook::timers; 0: it does not run
    std::uint32_t player = 0;               ///< whose turn it is, from 0

    /// `game begins` and `turn begins` are due, in the next tick.
    bool game_is_new = true;
    bool turn_is_new = true;

    std::uint64_t tick = 0;            ///< in which `actions` were counted
    std::uint32_t actions = 0;         ///< carried out in that tick
    std::uint64_t left_out = 0;        ///< actions beyond most_actions_in_a_tick, ever
    std::uint64_t first_left_out = 0;  ///< the tick of the first of them

    friend bool operator==(const RuleState&, const RuleState&) = default;
};

}  // namespace carom
