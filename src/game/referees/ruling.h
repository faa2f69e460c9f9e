#pragma once

#include <cstdint>
#include <vector>

#include "game/referees/pool_state.h"

/// Building blocks of referees: questions about a shot, and the pieces of a ruling.
namespace carom {

/// The ball's bit in sets such as PoolState::down. Pre: 0 <= ball < 32.
constexpr std::uint32_t ball_bit(int ball) {
    return std::uint32_t{1} << ball;
}

/// Whether the shot pocketed the ball, or the cue ball.
bool is_pocketed(const PoolShot& shot, int ball);
/// The object balls that the shot pocketed, as a set of bits.
std::uint32_t pocketed_object_balls(const PoolShot& shot);
/// Whether the shot pocketed the called ball in the called pocket.
bool made_call(const PoolShot& shot, const PoolCall& call);
/// Whether a break pocketed an object ball, or drove at least four to a cushion.
bool is_open_break(const PoolShot& shot);
/// The first of the fouls that every game has: scratch, no hit, wrong ball, behind the
/// head string, no rail.
PoolFoul common_foul(const PoolState& state, const PoolShot& shot);

/// The initial ruling: the phase is playing, nobody has ball in hand, and the balls that the shot
/// pocketed are down.
PoolRuling ruling_after(const PoolState& state, const PoolShot& shot);

void pass_turn(PoolState& state);
void win(PoolState& state, int player);
/// Lets the player whose turn it is choose. Pre: `choices` is not empty.
void let_choose(PoolState& state, std::vector<PoolChoice> choices);
/// Puts a pocketed ball back on the foot spot.
void spot(PoolRuling& ruling, int ball);

}  // namespace carom
