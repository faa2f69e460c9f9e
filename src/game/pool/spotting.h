#pragma once

#include <cstdint>

#include "game/pool/pool.h"

/// Puts balls on the table of a game of pool: racks, spots, the cue ball in hand.
namespace carom {

/// Puts a ball, which may be on the table or off it, on its spot: the foot spot, or its own spot.
/// If that is occupied, the foot spot's line is followed away from the rack's apex; a ball with a
/// spot of its own takes the free spot of the highest number, or else lies as near as it can to its
/// own, towards the foot of the table. The cue ball goes behind its line.
void put_on_spot(const Scene& scene, World& world, PoolPlay& play, int ball);

/// Puts all balls back to where they lay before the last shot (PoolPlay::lay).
void put_back(const Scene& scene, World& world, PoolPlay& play);

/// Straight pool: racks the balls that are off the table, without the apex ball, around the last
/// one. A last ball or cue ball in the way of the triangle goes where the rules say: the head spot,
/// the centre spot, into the rack, or in hand. (The table of WPA 4.9.)
void rack_rest(const Scene& scene, World& world, PoolPlay& play);

}  // namespace carom
