#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "game/referees/pool_state.h"

/// Building blocks of referees: questions about a shot, and the pieces of a ruling.
namespace carom {

/// The ball's bit in sets such as PoolState::down. Pre: 0 <= ball < 32.
constexpr std::uint32_t ball_bit(int ball) {
    return std::uint32_t{1} << ball;
}

/// The balls 1 to 15, as a set of bits.
inline constexpr std::uint32_t fifteen_balls = 0xfffe;

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
/// Counts a foul of this player, and returns whether it is one too many in a row.
bool counts_to_limit(PoolState& state, int player);
/// Adds points to the player's score, and to the run of the turn.
void score_points(PoolState& state, int points);
void win(PoolState& state, int player);
/// Lets the player whose turn it is choose. Pre: `choices` is not empty.
void let_choose(PoolState& state, std::vector<PoolChoice> choices);
/// Whether a choice is due, and this is one of those offered.
bool may_choose(const PoolState& state, PoolChoice choice);
/// Where pots are called: why the turn passes though a ball fell without a foul; else empty.
std::string_view uncalled_text(const PoolState& state, const PoolCall& call, const PoolShot& shot,
                               int shooter);
/// Puts a pocketed ball back on its spot.
void spot(PoolRuling& ruling, int ball);
/// Puts all balls of the set back, by descending numbers.
void spot_all(PoolRuling& ruling, std::uint32_t balls);

}  // namespace carom
