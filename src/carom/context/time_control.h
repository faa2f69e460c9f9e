#pragma once

#include "carom/context/play_context.h"

/// The player's command of time: pause, single ticks, a search, the way back.
namespace carom {

void toggle_pause(PlayContext& play);
void step_forward(PlayContext& play);
void step_back(PlayContext& play);
void seek_collision(PlayContext& play);
void second_forward(PlayContext& play);
void second_back(PlayContext& play);
void slower(PlayContext& play);
void faster(PlayContext& play);
void normal_speed(PlayContext& play);
void restart(PlayContext& play);

/// Lets `seconds` of the player's time pass: computes ticks as far as `may_go_on` allows, and says
/// what came of them. What runs beside the game keeps up with it, or the game waits.
void advance_time(PlayContext& play, double seconds, const MayGoOn& may_go_on);

}  // namespace carom
