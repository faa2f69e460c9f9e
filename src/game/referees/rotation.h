#pragma once

#include "game/referees/pool_state.h"

/// What 9-ball and 10-ball have in common: the lowest ball must be hit first.
namespace carom {

/// The lowest ball on the table; `last`, which is never off it in play, if the others are down.
int lowest_ball(const PoolState& state, int last);

/// The foul of a shot. A push-out is only fouled by a scratch, and a break must pocket a ball or
/// drive four to cushions.
PoolFoul rotation_foul(const PoolState& state, const PoolShot& shot, bool is_push);

/// Passes the turn after a foul, with ball in hand; or ends the frame, if it was one too many.
void penalize_rotation(PoolRuling& ruling);
/// Counts the foul of a player who was late in `state`, after which the frame may be over.
PoolRuling late_in_rotation(PoolRuling ruling, const PoolState& state);

}  // namespace carom
