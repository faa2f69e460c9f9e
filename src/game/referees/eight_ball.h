#pragma once

#include <optional>

#include "game/referees/pool_state.h"

/// The two groups of 8-ball.
namespace carom {

/// None for the cue ball and the 8.
std::optional<PoolGroup> group_of(int ball);
/// None while the table is open.
std::optional<PoolGroup> group_of_player(const PoolState& state, int player);

}  // namespace carom
