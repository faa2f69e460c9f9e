#pragma once

#include <cstdint>
#include <vector>

#include "game/pinball/pinball_table.h"

/// Players who take turns at a table, a ball each. Each has a score, extra balls and lights of its
/// own, and variables of the rules; the table itself is the same for all, and its drop targets rise
/// between turns.
namespace carom {

/// At the start of a game: the first player's turn, and nobody else has joined.
void begin_players(PinballState& state);

/// Another player joins, if one may (may_join).
void join(Pinball game);

/// Passes the turn to the player of the next ball. False: all balls are played.
bool pass_to_next_player(Pinball game);

/// The extra ball for the score of the level's replay=, once a game for each player.
void award_replay(Pinball game);

std::int64_t best_score(const PinballState& state);

}  // namespace carom
