#pragma once

#include <optional>

#include "game/pool/pool.h"

/// What the cue ball can hit in a straight line, for the rules of snooker.
namespace carom {

/// The sight of the player whose turn it is in `rules`. A ball on is hidden if a ball that is not
/// on lies in the way of one of its sides; balls on do not hide each other, and cushions hide
/// nothing. With the cue ball in hand it is that of the best place out of a grid over the D.
/// `called`: the ball that was called for the last shot, if one was.
/// Cost: balls on times balls, times the places of the grid.
PoolSight sight_of(const Scene& scene, const World& world, const PoolPlay& play,
                   const PoolState& rules, std::optional<int> called);

}  // namespace carom
