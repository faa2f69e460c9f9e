#pragma once

#include "carom/context/play_context.h"

/// The player's command of the laws of the world: solver and gravity.
namespace carom {

void next_solver(PlayContext& play);
/// On: as it last was, else as the level says, else gentle for the size of the scene.
void toggle_gravity(PlayContext& play);
/// A quarter turn, counter-clockwise.
void turn_gravity(PlayContext& play);

}  // namespace carom
