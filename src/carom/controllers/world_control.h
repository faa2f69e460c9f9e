#pragma once

#include "carom/context/play_context.h"

/// The player's control of the laws of the world: solver and gravity.
namespace carom {

void next_solver(PlayContext& play);
/// Turns gravity off or on. On: the last used value, else the level's, else a default for the size
/// of the scene.
void toggle_gravity(PlayContext& play);
/// Rotates gravity by a quarter turn, counter-clockwise.
void turn_gravity(PlayContext& play);

}  // namespace carom
