#pragma once

#include <cstdint>
#include <optional>

#include "game/referees/ruling.h"
#include "game/referees/snooker.h"

/// What a stroke at snooker was worth, and what was wrong with it: balls on, points and penalties.
namespace carom::snooker {

/// The bits of the colours in PoolState::down.
inline constexpr std::uint32_t all_colors = 0x3f0000;
/// Of any foul.
inline constexpr int least_penalty = 4;

int reds_left(const PoolState& state);
/// The colour that comes next when the reds are gone.
int lowest_color(const PoolState& state);
bool is_on(const PoolState& state, int ball);
/// The most that can still be scored without fouls.
int points_left(const PoolState& state);
/// Whether the player behind can only win by the opponent's fouls.
bool needs_penalties(const PoolState& state);

/// What the striker has to hit and may pocket in this stroke.
struct Task {
    /// The ball that the striker named, where the striker had to name one.
    std::optional<int> named;
    int value = 1;  ///< of the ball on
};
Task task_of(const PoolState& state, const PoolCall& call, const PoolShot& shot);

struct Offence {
    PoolFoul foul = PoolFoul::none;
    int penalty = 0;
};
/// The first foul of the stroke; the penalty is that of the most valuable ball concerned.
Offence offence_of(const PoolState& state, const Task& task, const PoolShot& shot);

/// The points of a fair stroke.
int points_of(const PoolState& state, const Task& task, const PoolShot& shot);
/// The colours that come back after a fair stroke: all but the one that is cleared in order.
std::uint32_t returning(const PoolState& state, std::uint32_t pocketed);

}  // namespace carom::snooker
