#pragma once

#include <array>

#include "game/referees/pool_state.h"
#include "geometry/vector.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// Places on a pool table.
namespace carom {

/// The rack of the scene's game. Pre: it is a game of pool.
const Rack& rack_of(const Scene& scene);

/// The number of object balls; they are numbered from 1.
int object_balls(const Scene& scene);
/// The ball with this number as the level has it. Pre: 0 <= ball <= object_balls().
BallId first_ball(const Scene& scene, int ball);
/// Where the level puts it.
Vec2 home_of(const Scene& scene, int ball);

/// The corner pockets at the foot of the table, right and left as seen from the head.
std::array<int, 2> foot_pockets(const Scene& scene);

/// The head spot: the middle of the head string, where the cue ball starts.
Vec2 head_spot(const Scene& scene);

/// Whether a place is on the head string or beyond it, seen from the head of the table.
bool is_beyond_string(const Scene& scene, Vec2 place);

/// Whether the cue ball in hand may lie there: behind the head string, or in the D of snooker,
/// which goes through the spots of yellow, brown and green. Pre: it is in hand.
bool is_in_hand_area(const Scene& scene, CueInHand in_hand, Vec2 place);

/// Whether a ball can be placed there, on the cloth and not over a pocket; other balls are ignored.
/// For a convex table.
bool is_on_table(const Scene& scene, const World& world, Vec2 place, double radius);

/// Whether no ball overlaps a ball of this radius there.
bool is_free(const World& world, Vec2 place, double radius);

/// The nearest free place from `spot` along `direction`, a unit vector; if there is none within 20
/// radii, in the opposite direction; else `spot`.
Vec2 free_place(const World& world, Vec2 spot, Vec2 direction, double radius);

}  // namespace carom
