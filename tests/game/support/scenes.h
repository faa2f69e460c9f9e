#pragma once

#include "level/scene/scene.h"

/// Small hand-made scenes for tests of the game.
namespace carom::test {

/// Nine balls of radius 1 with different velocities in a box of 40 x 30 with thick walls: elastic,
/// without gravity. Edge 4 stands alone; edges 5 and 6 form a joint at 30,20.
Scene busy_box();

/// busy_box on a torus, with gravity and losses.
Scene rainy_torus();

/// A resting ball of the first kind.
BallSpec ball_at_rest(Vec2 place);

}  // namespace carom::test
